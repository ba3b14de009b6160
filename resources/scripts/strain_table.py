#!/usr/bin/env python3
"""strain_table.py [BUILD_DIRECTORY] [--write]

Runs the tests that hold the numbers of strain (tests/support/held_value.h) and the benchmark of a beat, and prints the table
"How it is held" of docs/strain.md: what is compared, the largest difference that was measured, the most that the test allows,
and its name. With --write the table of the page is replaced. Tests whose data are absent keep their row.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/strain.md"
HEAD = "| what | largest difference | at most | test |\n|---|---|---|---|\n"
# Programs and their tests, in the table's order.
TESTS = [
    ("test_strain", "MaterialStrain.Of*:WallFields.GiveTheStrain*:HeartStrain.IsTheSameAfter*:HeartAxes.CountFrom*:WallMeans.Deviate*"),
    ("test_patient_motion", "StrainReading.IsTheSameWithSixty*"),
    ("test_cli", "CliStrain.OfTheTextbook*:CliStrain.OfARealVentricle*"),
]
BENCHMARK = "strainOfABeat"


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}")
    return done.stdout


def held_rows(program, tests):
    """(what, value, bound, test) of each value that the tests of a program have recorded."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "tests.json"
        run([str(program), f"--gtest_filter={tests}", f"--gtest_output=json:{file}"])
        for suite in json.loads(file.read_text(encoding="utf-8"))["testsuites"]:
            for test in suite["testsuite"]:
                for key, text in test.items():
                    if key.startswith("held: "):
                        value, bound = text.split(" | ")
                        yield key[len("held: "):], value, bound, f"`{program.name}`, `{suite['name']}.{test['name']}`"


def beat_row(program):
    """The time of a whole beat, the least of three runs, since machines are noisy."""
    options = [f"--benchmark_filter={BENCHMARK}", "--benchmark_format=json", "--benchmark_repetitions=3"]
    lines = subprocess.run([str(program)] + options, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    runs = [one for one in json.loads(lines.stdout)["benchmarks"] if one["run_type"] == "iteration"]
    what = f"{runs[0]['phases']:.0f} phases with {runs[0]['witnesses']:,.0f} witness points and 120 handles"
    return what, f"{min(one['real_time'] for one in runs) / 1000:.2f} s", "1 s", f"`{program.name}`"


def table(build):
    rows = [row for program, tests in TESTS for row in held_rows(build / "bin" / program, tests)]
    rows.append(beat_row(build / "bin" / "bench_strain"))
    return HEAD + "".join(f"| {' | '.join(row)} |\n" for row in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    made = table(options.build)
    print(made, end="")
    if options.write:
        page = PAGE.read_text(encoding="utf-8")
        begin = page.index("| what | largest")
        PAGE.write_text(page[:begin] + made + page[page.index("\n\n", begin) + 1:], encoding="utf-8")


if __name__ == "__main__":
    main()
