#!/usr/bin/env python3
"""Measures the filters by size and number of ranks, in one run, and writes the table of docs/scaling.md.

    /usr/bin/python3 resources/scripts/measure_scaling.py build/release

Rounds go through all rows in turn, so that what else the machine does hits all alike; of each number the least is taken. Six
minutes and 7 GB of memory; `--small` measures 2 million vertices alone. Ends with an error when a volume has other bits on
another number of ranks.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/scaling.md"
BEGIN, END = "<!-- measure_scaling.py: from here -->\n", "<!-- measure_scaling.py: to here -->\n"
#: Rings and segments of the surface, what is asked of the benchmark, and on how many ranks.
ROWS = [((1000, 2000), ["stress"], ranks) for ranks in (1, 2, 4)]
ROWS += [((1000, 2000), ["drop"], ranks) for ranks in (1, 2, 4)]
LARGE = [((2857, 7000), ["drop"], ranks) for ranks in (1, 2, 4)]


def measure(build, size, options, ranks):
    """One line of filter_by_ranks.py."""
    environment = {
        **os.environ,
        "PYTHONPATH": f"{build}/python:{build}/lib/python3/dist-packages",
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
        "OMP_NUM_THREADS": "1",
    }
    command = ["mpirun", "--oversubscribe", "-np", str(ranks), sys.executable, str(ROOT / "tests/bench/filter_by_ranks.py")]
    done = subprocess.run([*command, *map(str, size), *options], env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{size} on {ranks} ranks:\n{done.stdout}\n{done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def least(rounds):
    """The least of each time; the rest is the same in all rounds, but for memory, of which the most counts."""
    found = dict(rounds[0])
    for key in found:
        if key.endswith("_s"):
            found[key] = [min(times) for times in zip(*(each[key] for each in rounds))]
        elif key.endswith("_mib"):
            found[key] = [max(memory) for memory in zip(*(each[key] for each in rounds))]
    return found


def require_same_bits(rows):
    """Ends the run when the ranks play a part in a volume."""
    for key in ("volume", "locked_volume", "mean_stress"):
        bits = {}
        for row in rows:
            if key in row:
                bits.setdefault(row["segments"], set()).add(row[key])
        if any(len(each) > 1 for each in bits.values()):
            sys.exit(f"{key} has other bits on another number of ranks: {bits}")


def cell(row, key):
    """Processors' time over all ranks, and by the clock."""
    return f"{row[key][1]:.2f} / {row[key][0]:.2f}" if key in row else ""


def table(rows):
    lines = [
        "| vertices | coordinates | ranks | deform, first pose | another pose | volume locked | stress | memory a rank: piece, most |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        times = " | ".join(cell(row, key) for key in ("first_pose_s", "another_pose_s", "locked_pose_s", "stress_s"))
        kept = "kept" if row["keep"] else "not kept"
        memory = f"{max(row['piece_mib']):,}, {max(row['deform_mib']):,} MiB"
        lines.append(f"| {row['distinct']:,} | {kept} | {row['ranks']} | {times} | {memory} |")
    return "\n".join(lines) + "\n"


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("build", help="a build directory with the Python packages")
    options.add_argument("--small", action="store_true", help="2 million vertices alone; prints the table")
    options.add_argument("--rounds", type=int, default=2, help="how often each row is measured")
    given = options.parse_args()
    build = pathlib.Path(given.build).resolve()
    rows = ROWS + ([] if given.small else LARGE)
    rounds = [[] for _ in rows]
    for _ in range(given.rounds):
        for found, (size, wanted, ranks) in zip(rounds, rows):
            found.append(measure(build, size, wanted, ranks))
            print(json.dumps(found[-1]), file=sys.stderr, flush=True)
    measured = []
    for found, ((rings, segments), _, _) in zip(rounds, rows):
        measured.append({**least(found), "segments": segments, "distinct": (rings + 1) * segments})
    require_same_bits(measured)
    text = table(measured)
    print(text)
    if not given.small:
        before, rest = PAGE.read_text().split(BEGIN)
        PAGE.write_text(before + BEGIN + text + END + rest.split(END)[1])


if __name__ == "__main__":
    main()
