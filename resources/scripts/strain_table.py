#!/usr/bin/env python3
"""strain_table.py [BUILD_DIRECTORY] [--write | --check]

Runs the tests that hold the numbers of strain (tests/support/held_value.h) and the benchmark of a beat, and prints the table
"How it is held" of docs/strain.md: what is compared, the largest difference that was measured, the most that the test allows,
and its name. A row whose data or program is absent is kept as it is on the page.

  --write     replaces the table of the page
  --check     compares the page with the sources, and, where a build directory is given, with what is measured there: ends with an
              error when a row, a bound or a test differs, or a value is above its bound. Values differ between machines:
              other differences are printed only, and the time needs a quiet machine
  --page F    a page in the place of docs/strain.md
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "| what | largest difference | at most | test |\n|---|---|---|---|\n"
# Test programs and the sources of theirs that hold values.
SOURCES = {
    "test_strain": "tests/unit/motion/strain/*_test.cpp",
    "test_patient_motion": "tests/unit/live/strain_*_test.cpp",
    "test_cli": "tests/contract/cli/strain_test.cpp",
}
BENCHMARK, BENCH_CELLS = "strainOfABeat", ["1 s", "`bench_strain`"]
TEST_OR_VALUES = re.compile(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)|\bHeldValue\s+([^;]*);", re.M)
VALUE = re.compile(r'\w\(\s*((?:"[^"]*"\s*)+),\s*([\w.+-]+)\s*(?:,\s*"([^"]*)"\s*)?\)')


def values_of(file, program):
    """(what, bound, test) of each HeldValue that a source declares."""
    text = file.read_text(encoding="utf-8")
    test = ""
    for found in TEST_OR_VALUES.finditer(text):
        if found[1]:
            test = f"{found[1]}.{found[2]}"
            continue
        values = VALUE.findall(found[3])
        if not values:
            sys.exit(f"{file.name}, {test}: the row, the bound and the unit of a HeldValue have to be literals: {found[0]}")
        for row, bound, unit in values:
            constant = re.search(rf"\bconstexpr double {re.escape(bound)} = ([\d.e+-]+);", text)
            words = f"{float(constant[1] if constant else bound):.2g} {unit}".rstrip()  # As held_value.h writes it.
            yield "".join(re.findall(r'"([^"]*)"', row)), words, f"`{program}`, `{test}`"


def declared_rows():
    """What the sources say: bound and test of each row."""
    rows = {}
    for program, sources in SOURCES.items():
        for file in sorted(ROOT.glob(sources)):
            for what, *cells in values_of(file, program):
                if what in rows:
                    sys.exit(f"two tests hold a row of the same name: {what}")
                rows[what] = cells
    return rows


def rows_of_page(page):
    """The other cells of each row by the first one."""
    text = page.read_text(encoding="utf-8")
    if HEAD not in text:
        sys.exit(f"{page.name} has no table that begins with {HEAD.splitlines()[0]}")
    begin = text.index(HEAD) + len(HEAD)
    lines = text[begin:text.index("\n\n", begin - 1)].splitlines()
    return {what: cells for what, *cells in ([cell.strip() for cell in line.strip("|").split("|")] for line in lines)}


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}")
    return done.stdout


def held_rows(program, tests):
    """(what, value, bound, test) of each value that the tests of a program have recorded; none without the program."""
    if not program.exists():
        print(f"{program.name} is not built", file=sys.stderr)
        return
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "tests.json"
        run([str(program), f"--gtest_filter={':'.join(tests)}", f"--gtest_output=json:{file}"])
        for suite in json.loads(file.read_text(encoding="utf-8"))["testsuites"]:
            for test in suite["testsuite"]:
                for key, text in test.items():
                    if key.startswith("held: "):
                        value, bound = text.split(" | ")
                        yield key[len("held: "):], value, bound, f"`{program.name}`, `{suite['name']}.{test['name']}`"


def beat_row(program):
    """The time of a whole beat, the least of three runs, since machines are noisy; none without the program."""
    if not program.exists():
        print(f"{program.name} is not built", file=sys.stderr)
        return
    options = [f"--benchmark_filter={BENCHMARK}", "--benchmark_format=json", "--benchmark_repetitions=3"]
    lines = subprocess.run([str(program)] + options, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    runs = [one for one in json.loads(lines.stdout)["benchmarks"] if one["run_type"] == "iteration"]
    what = f"{runs[0]['phases']:.0f} phases with {runs[0]['witnesses']:,.0f} witness points and 120 handles"
    yield what, f"{min(one['real_time'] for one in runs) / 1000:.2f} s", *BENCH_CELLS


def measured_rows(build, declared):
    rows = {}
    for program in SOURCES:
        tests = sorted({re.findall(r"`([^`]*)`", test)[1] for _, test in declared.values() if test.startswith(f"`{program}`")})
        for what, *cells in held_rows(build / "bin" / program, tests):
            if declared.get(what) != cells[1:]:
                sys.exit(f"{program} is older than the sources; build it again: {what}, {', '.join(cells[1:])}")
            rows[what] = cells
    for what, *cells in beat_row(build / "bin" / "bench_strain"):
        rows[what] = cells
    return rows


def table(page_rows, declared, measured):
    """In the page's order, new rows at the end."""
    benched = any(cells[1:] == BENCH_CELLS for cells in measured.values())
    rows = {}
    for what, cells in page_rows.items():
        if what in measured:
            rows[what] = measured[what]
        elif what in declared or (cells[1:] == BENCH_CELLS and not benched):
            print(f"not measured, as on the page: {what}", file=sys.stderr)
            rows[what] = cells
    rows.update({what: cells for what, cells in measured.items() if what not in rows})
    return HEAD + "".join(f"| {what} | {' | '.join(cells)} |\n" for what, cells in rows.items())


def within(value, bound):
    """Whether the number in a cell is at most that in another; not where it is none."""
    numbers = [re.match(r"[\d.]+(?:e[-+]?\d+)?(?= |$)", cell) for cell in (value, bound)]
    return all(numbers) and float(numbers[0][0]) <= float(numbers[1][0])


def differences(page_rows, declared, measured):
    """What is wrong on the page, or above its bound in this build."""
    for what in declared:
        if what not in page_rows:
            yield f"is not on the page: {what}"
    if BENCH_CELLS not in [cells[1:] for cells in page_rows.values()]:
        yield f"is not on the page: the row of {' to '.join(reversed(BENCH_CELLS))}"
    for what, (value, *cells) in page_rows.items():
        expected = declared.get(what, BENCH_CELLS)
        if what not in declared and cells[-1] != BENCH_CELLS[-1]:
            yield f"is held by no test: {what}"
        elif cells != expected:
            yield f"{what}: the page says {', '.join(cells)}; the sources {', '.join(expected)}"
        elif not within(value, cells[0]):
            yield f"{what}: on the page {value}, to {cells[0]}"
    for what, (value, bound, _) in measured.items():
        if not within(value, bound):
            yield f"{what}: here {value}, to {bound}"
        elif what not in page_rows:
            yield f"is measured here and not on the page: {what}"
        elif value != page_rows[what][0]:
            print(f"{what}: here {value}, on the page {page_rows[what][0]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, default=ROOT / "docs/strain.md")
    way = parser.add_mutually_exclusive_group()
    way.add_argument("--write", action="store_true")
    way.add_argument("--check", action="store_true")
    options = parser.parse_args()
    build = options.build if options.build or options.check else ROOT / "build/release"
    declared, page_rows = declared_rows(), rows_of_page(options.page)
    measured = measured_rows(build.resolve(), declared) if build else {}
    if options.check:
        wrong = list(differences(page_rows, declared, measured))
        print("\n".join(wrong))
        sys.exit(1 if wrong else 0)
    made = table(page_rows, declared, measured)
    print(made, end="")
    if options.write:
        text = options.page.read_text(encoding="utf-8")
        begin = text.index(HEAD)
        options.page.write_text(text[:begin] + made + text[text.index("\n\n", begin) + 1:], encoding="utf-8")


if __name__ == "__main__":
    main()
