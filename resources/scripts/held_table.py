#!/usr/bin/env python3
"""held_table.py [BUILD_DIRECTORY] [--write | --check]

Runs the tests that hold the numbers of a page (tests/support/held_value.h) and prints its table: what is measured, its value, what the
test allows, its name, and where a range has one, who says so. Of strain the page is docs/strain.md ("How it is held"), with the
benchmark of a beat; of the sample heart docs/sample_organs.md ("How the heart is held"). A row whose data or program is absent is
kept as it is on the page.

  --write     replaces the table of each page
  --check     compares the pages with the sources, and, where a build directory is given, with what is measured there: ends with an
              error when a row, a bound or a test differs, or a value is beyond its bound. Values differ between machines:
              other differences are printed only, and the time needs a quiet machine
  --table T   this table only, "strain" or "heart"
  --page F    a page in the place of that table's own
"""
import argparse
import dataclasses
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Table:
    """A table of a page, and where its rows come from."""
    page: pathlib.Path
    head: str
    sources: dict  # Test programs and the sources of theirs that hold values.
    cited: bool = False  # A column says who has measured a range.
    benched: bool = False  # A row is the time of a benchmark.


TABLES = {
    "strain": Table(ROOT / "docs/strain.md", "| what | largest difference | at most | test |\n|---|---|---|---|\n", {
        "test_strain": "tests/unit/motion/strain/*_test.cpp",
        "test_patient_motion": "tests/unit/live/strain_*_test.cpp",
        "test_cli": "tests/contract/cli/strain_test.cpp",
    }, benched=True),
    "heart": Table(ROOT / "docs/sample_organs.md", "| what | here | held to | whose range | test |\n|---|---|---|---|---|\n", {
        "test_organs": "tests/unit/sample_organs/heart_*_test.cpp",
        "test_sequence_setup": "tests/unit/live/heart_*_test.cpp",
        "test_presentation": "tests/unit/presentation/heart_*_test.cpp",
    }, cited=True),
}
BENCHMARK, BENCH_CELLS = "strainOfABeat", ["1 s", "`bench_strain`"]
STRINGS = r'((?:"[^"]*"\s*)+)'
TEST_OR_VALUES = re.compile(r'^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)|\bHeldValue\s+([^;]*);'
                            r'|\bHeldRange\s+\w+\(((?:[^"()]|"[^"]*")*)\);', re.M)
VALUE = re.compile(r'\w\(\s*' + STRINGS + r',\s*([\w.+-]+)\s*(?:,\s*"([^"]*)"\s*)?\)')
RANGE = re.compile(r'\s*' + STRINGS + r',\s*([\w.+-]+)\s*,\s*([\w.+-]+)\s*,\s*"([^"]*)"\s*,\s*' + STRINGS)
NUMBER = r"-?[\d.]+(?:e[-+]?\d+)?"


def literal(strings):
    return "".join(re.findall(r'"([^"]*)"', strings))


def number_of(words, text):
    """A literal, or a constant of the file."""
    constant = re.search(rf"\bconstexpr double {re.escape(words)} = ([\d.e+-]+);", text)
    return float(constant[1] if constant else words)


def in_words(low, high, unit):
    """As held_value.h writes a range."""
    low, high = f"{low:.3g}", f"{high:.3g}"
    return f"{low if low == high else f'{low} to {high}'} {unit}".rstrip()


def range_of(declared, text, place):
    """Row, bounds and source of a HeldRange."""
    found = RANGE.fullmatch(declared)
    if not found:
        sys.exit(f"{place}: row, unit and source of a HeldRange have to be literals: {declared}")
    return literal(found[1]), in_words(number_of(found[2], text), number_of(found[3], text), found[4]), literal(found[5])


def values_of(file, program, cited):
    """(what, bound, test) of each value that a source holds; with who says so behind the bound where that is cited."""
    text = file.read_text(encoding="utf-8")
    test = ""
    for found in TEST_OR_VALUES.finditer(text):
        if found[1]:
            test = f"{found[1]}.{found[2]}"
            continue
        if found[4]:
            yield *range_of(found[4], text, f"{file.name}, {test}"), f"`{program}`, `{test}`"
            continue
        values = VALUE.findall(found[3])
        if not values:
            sys.exit(f"{file.name}, {test}: the row, the bound and the unit of a HeldValue have to be literals: {found[0]}")
        for row, bound, unit in values:
            words = f"{number_of(bound, text):.2g} {unit}".rstrip()  # As held_value.h writes it.
            yield literal(row), *bound_cells(words, cited), f"`{program}`, `{test}`"


def bound_cells(words, cited):
    """The cells of a bound that nobody is cited for."""
    return [f"at most {words}", ""] if cited else [words]


def declared_rows(table):
    """What the sources say: bound and test of each row."""
    rows = {}
    for program, sources in table.sources.items():
        for file in sorted(ROOT.glob(sources)):
            for what, *cells in values_of(file, program, table.cited):
                if what in rows:
                    sys.exit(f"two tests hold a row of the same name: {what}")
                rows[what] = cells
    return rows


def rows_of_page(page, head):
    """The other cells of each row by the first one."""
    text = page.read_text(encoding="utf-8")
    if head not in text:
        sys.exit(f"{page.name} has no table that begins with {head.splitlines()[0]}")
    begin = text.index(head) + len(head)
    lines = text[begin:text.index("\n\n", begin - 1)].splitlines()
    return {what: cells for what, *cells in ([cell.strip() for cell in line[1:-1].split("|")] for line in lines)}


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}")
    return done.stdout


def held_rows(program, tests, cited):
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
                        value, bound, *source = text.split(" | ")
                        cells = [bound, *source] if source else bound_cells(bound, cited)
                        yield key[len("held: "):], value, *cells, f"`{program.name}`, `{suite['name']}.{test['name']}`"


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


def measured_rows(table, build, declared):
    rows = {}
    for program in table.sources:
        tests = sorted({re.findall(r"`([^`]*)`", test)[1] for *_, test in declared.values() if test.startswith(f"`{program}`")})
        if not tests:
            continue
        for what, *cells in held_rows(build / "bin" / program, tests, table.cited):
            if declared.get(what) != cells[1:]:
                sys.exit(f"{program} is older than the sources; build it again: {what}, {', '.join(cells[1:])}")
            rows[what] = cells
    for what, *cells in beat_row(build / "bin" / "bench_strain") if table.benched else ():
        rows[what] = cells
    return rows


def table_of(head, page_rows, declared, measured):
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
    return head + "".join(f"| {what} | {' | '.join(cells)} |\n" for what, cells in rows.items())


def within(value, bound):
    """Whether the numbers in a cell lie within those of another, "18 to 37 mm" or "5 %"; not where there is none."""
    found = [re.match(rf"(?:at most )?({NUMBER})(?: to ({NUMBER}))?(?= |$)", cell) for cell in (value, bound)]
    if not all(found):
        return False
    (low, high), (least, most) = ([float(one[1]), float(one[2] or one[1])] for one in found)
    return high <= most and (found[1][2] is None or low >= least)


def differences(table, page_rows, declared, measured):
    """What is wrong on the page, or above its bound in this build."""
    for what in declared:
        if what not in page_rows:
            yield f"is not on the page: {what}"
    if table.benched and BENCH_CELLS not in [cells[1:] for cells in page_rows.values()]:
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


def done_with(table, page, options):
    """What is wrong of one table; writes it where that is wanted."""
    build = options.build if options.build or options.check else ROOT / "build/release"
    declared, page_rows = declared_rows(table), rows_of_page(page, table.head)
    measured = measured_rows(table, build.resolve(), declared) if build else {}
    if options.check:
        return list(differences(table, page_rows, declared, measured))
    made = table_of(table.head, page_rows, declared, measured)
    print(made, end="")
    if options.write:
        text = page.read_text(encoding="utf-8")
        begin = text.index(table.head)
        page.write_text(text[:begin] + made + text[text.index("\n\n", begin) + 1:], encoding="utf-8")
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("--table", choices=TABLES)
    parser.add_argument("--page", type=pathlib.Path)
    way = parser.add_mutually_exclusive_group()
    way.add_argument("--write", action="store_true")
    way.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.page and not options.table:
        parser.error("--page needs --table")
    wrong = []
    for name in [options.table] if options.table else TABLES:
        wrong += done_with(TABLES[name], options.page or TABLES[name].page, options)
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
