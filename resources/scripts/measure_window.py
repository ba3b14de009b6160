#!/usr/bin/env python3
"""Measures what a hand on the window waits for, before and now, in one run, and prints the tables.

    resources/scripts/measure_window.py build/release [--before OTHER_BUILD]

Some rows have both within one build: with and without fewer triangles while something moves, blending in place of peeling, and
volume forms that were made earlier. The others (the start, a click) need a build of an older commit, whose benchmarks run in
turn with those of the build. Each row is the median of the rounds; of each round it is the mean over the events. Without a
display Xvfb has to be there.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

#: Start, drag, click and proxy; `--all` has the other steps of a work as well.
QUICK = "^(firstPicture|startTheProgram|drag|press|click|firstLockedStep|firstLockedMove|playTheHeart|turnTheView)"
STEPS = QUICK[:-1] + "|undoAPose|redoAPose|changeTheMode|fadeAnOrgan)"
#: What is a way of doing something: of before (0) or of now (1).
SWITCH = re.compile(r"/(?:blended|proxy|prepared|shortcuts):([01])")
WAYS = {"made_in_it": "before", "made_before": "now"}
#: 3 or 95 organs, of rows that are compared by it.
ORGANS = re.compile(r"^(clickAnOrgan/|dragAPatient/|fadeAnOrgan/|undoAPose/organs_|changeTheMode/organs_)(3|95)(?=/|$)")


def run(program, pattern):
    """Names and milliseconds of the benchmarks of a program; none where it is not built."""
    if not program.exists():
        return {}
    with tempfile.NamedTemporaryFile(suffix=".json") as found:
        command = [str(program), f"--benchmark_filter={pattern}", f"--benchmark_out={found.name}", "--benchmark_out_format=json"]
        if "DISPLAY" not in os.environ and program.name == "bench_window":
            command = ["xvfb-run", "-a", "-s", "-screen 0 1920x1200x24 -nolisten tcp", *command]
        done = subprocess.run(command, stdout=sys.stderr, check=False)
        text = pathlib.Path(found.name).read_text(encoding="utf-8")
    if done.returncode != 0:
        sys.exit(f"{program} ended with {done.returncode}")
    return times(json.loads(text)) if text else {}  # Nothing is written where no name matches.


def times(report):
    factor = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
    return {
        re.sub(r"/(iterations:\d+|manual_time|real_time)", "", one["name"]): one["real_time"] * factor[one["time_unit"]]
        for one in report["benchmarks"]
        if not one.get("error_occurred") and one.get("run_type", "iteration") == "iteration"
    }


def place(name):
    """Row and column of a benchmark."""
    column = "now"
    switched = SWITCH.search(name)
    if switched and switched[1] == "0":
        column = "before"
    name = SWITCH.sub("", name)
    for way, side in WAYS.items():
        if name.endswith("/" + way):
            name, column = name[: -len(way) - 1], side
    return re.sub(r"/\w+:", "/", name), column


def tabulate(rounds, older):
    """Rows of milliseconds by column: `older`, `before` and `now`."""
    rows = {}
    for column, results in (("older", older), (None, rounds)):
        for result in results:
            for name, milliseconds in result.items():
                row, own = place(name)
                if column and own != "now":
                    continue
                rows.setdefault(row, {}).setdefault(column or own, []).append(milliseconds)
    return {row: {column: statistics.median(found) for column, found in columns.items()} for row, columns in rows.items()}


def written(milliseconds):
    return "-" if milliseconds is None else f"{milliseconds:,.0f}" if milliseconds >= 10 else f"{milliseconds:.1f}"


def print_pairs(rows, older):
    columns = (["older"] if older else []) + ["before", "now"]
    titles = {"older": "older build", "before": "before, in this build", "now": "now"}
    print("| ms | " + " | ".join(titles[column] for column in columns) + " |")
    print("|---" * (len(columns) + 1) + "|")
    for row, found in rows.items():
        print(f"| {row} | " + " | ".join(written(found.get(column)) for column in columns) + " |")


def print_organs(rows):
    pairs = {}
    for row, found in rows.items():
        match = ORGANS.match(row)
        if match:
            pairs.setdefault(ORGANS.sub(r"\1N", row), {})[match[2]] = found.get("now")
    if not pairs:
        return
    print("\n| ms | 3 organs | 95 organs |\n|---|---|---|")
    for row, found in pairs.items():
        print(f"| {row} | {written(found.get('3'))} | {written(found.get('95'))} |")


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("build", help="a build directory with the target viscera_bench")
    options.add_argument("--before", help="a build directory of an older commit, measured in turn with the other")
    options.add_argument("--rounds", type=int, default=3, help="how often each row is measured")
    options.add_argument("--all", action="store_true", help="undo, redo, modes and opacity as well")
    options.add_argument("--filter", help="the benchmarks whose names match this instead")
    given = options.parse_args()
    if "DISPLAY" not in os.environ and not shutil.which("xvfb-run"):
        sys.exit("There is no display, and no xvfb-run.")
    builds = [pathlib.Path(build).resolve() for build in ([given.before] if given.before else []) + [given.build]]
    pattern = given.filter or (STEPS if given.all else QUICK)
    found = [[] for _ in builds]
    for _ in range(given.rounds):
        for build, results in zip(builds, found):
            if not (build / "bin/bench_window").exists():
                sys.exit(f"There is no bench_window in {build}/bin. Build the target viscera_bench.")
            results.append({**run(build / "bin/bench_window", pattern), **run(build / "bin/bench_lock", pattern)})
    rows = tabulate(found[-1], found[0] if given.before else [])
    print_pairs(rows, given.before)
    print_organs(rows)


if __name__ == "__main__":
    main()
