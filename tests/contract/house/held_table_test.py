"""held_table_test.py SOURCE_DIRECTORY WORK_DIRECTORY: the tables of docs/strain.md and docs/sample_organs.md have the rows, bounds and
tests of the sources, and held_table.py finds what differs. Runs no test program: those here are made up."""
import pathlib
import shutil
import subprocess
import sys

source, work = map(pathlib.Path, sys.argv[1:])
SCRIPT, PAGE = source / "resources/scripts/held_table.py", source / "docs/strain.md"
STRETCH, SHEAR, SUITE, NAME = "uniform stretch", "simple shear", "MaterialStrain", "OfAUniformStretchIsTheStretchAlongEachAxis"
#: A test program that says what a real one does; the test of the shear is skipped.
PROGRAM = """#!{python}
import json, sys
report = next(option for option in sys.argv if option.startswith("--gtest_output=json:"))
assert any(option.startswith("--gtest_filter=") and "{suite}.{name}" in option for option in sys.argv)
tests = [dict([("name", "{name}"), ("held: {what}", "{value} | {bound}")]), dict(name="OfASimpleShear", result="SKIPPED")]
with open(report.split(":", 1)[1], "w") as file:
    json.dump(dict(testsuites=[dict(name="{suite}", testsuite=tests)]), file)
"""
BENCHMARK = """#!{python}
print('{{"benchmarks": [{{"run_type": "iteration", "phases": 25, "witnesses": 13441, "real_time": 125}}]}}')
"""


def check(condition, message):
    if not condition:
        sys.exit(str(message))


def run(*arguments, table="strain"):
    done = subprocess.run([sys.executable, SCRIPT, *arguments, "--table", table], check=False, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def build_that_says(value, bound="1e-10"):
    programs = {
        "test_strain": PROGRAM.format(python=sys.executable, suite=SUITE, name=NAME, what=STRETCH, value=value, bound=bound),
        "bench_strain": BENCHMARK.format(python=sys.executable),
    }
    for name, text in programs.items():
        program = work / "build/bin" / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text(text, encoding="utf-8")
        program.chmod(0o755)
    return work / "build"


def page_with(text):
    page = work / "strain.md"
    page.write_text(text, encoding="utf-8")
    return page


def row_of(text, what):
    return next(line for line in text.splitlines() if line.startswith(f"| {what} |"))


def test_differences(text):
    row = row_of(text, STRETCH)
    cells = row.split(" | ")
    beat = next(line for line in text.splitlines() if line.endswith("| `bench_strain` |"))
    changed = {
        "no row": (text.replace(row + "\n", ""), STRETCH),
        "a row too many": (text.replace(row, row + "\n" + row.replace("uniform", "uneven")), "uneven stretch"),
        "another bound": (text.replace(row, " | ".join([*cells[:2], "1e-12", cells[3]])), STRETCH),
        "another test": (text.replace(row, row.replace("OfAUniform", "OfAnUneven")), STRETCH),
        "a value above its bound": (text.replace(row, " | ".join([cells[0], "1e-9", *cells[2:]])), STRETCH),
        "no value": (text.replace(row, " | ".join([cells[0], "-", *cells[2:]])), STRETCH),
        "no time": (text.replace(beat + "\n", ""), "bench_strain"),
    }
    for name, (other, expected) in changed.items():
        check(other != text, f"{name}: nothing was changed")
        code, said = run("--check", "--page", page_with(other))
        check(code == 1 and expected in said, f"{name}: {code}, {said}")


def test_measurements(text):
    page = page_with(text)
    code, said = run(build_that_says("3e-09"), "--check", "--page", page)
    check(code == 1 and f"{STRETCH}: here 3e-09, to 1e-10" in said, f"a value above the bound: {code}, {said}")
    code, said = run(build_that_says("nan"), "--check", "--page", page)
    check(code == 1 and f"{STRETCH}: here nan, to 1e-10" in said, f"not a number: {code}, {said}")
    code, said = run(build_that_says("1e-14", bound="1e-08"), "--check", "--page", page)
    check(code == 1 and "build it again" in said, f"a program that is older than the sources: {code}, {said}")
    code, said = run(build_that_says("3.2e-14"), "--write", "--page", page)
    check(code == 0 and f"not measured, as on the page: {SHEAR}" in said, f"a table is written: {code}, {said}")
    written = page.read_text(encoding="utf-8")
    check(row_of(written, STRETCH).startswith(f"| {STRETCH} | 3.2e-14 | 1e-10 |"), written)
    check(row_of(written, "25 phases with 13,441 witness points and 120 handles").endswith(" | 0.12 s | 1 s | `bench_strain` |"), written)
    changed = [line for line in text.splitlines() if line not in written.splitlines()]
    check(len(changed) == 2 and written.count("\n") == text.count("\n"), f"other lines were changed, too: {changed}")
    code, said = run(build_that_says("3.1e-14"), "--check", "--page", page)
    check(code == 0 and f"{STRETCH}: here 3.1e-14, on the page 3.2e-14" in said, f"another value within the bound: {code}, {said}")


def test_ranges(text):
    """A range has two ends, and who says so."""
    what = "mitral annulus, lesser and greater diameter"
    row = row_of(text, what)
    cells = row.split(" | ")
    changed = {
        "below its range": [cells[0], "17 to 31.7 mm", *cells[2:]],
        "above its range": [cells[0], "23.6 to 37.1 mm", *cells[2:]],
        "another range": [*cells[:2], "18 to 38 mm", *cells[3:]],
        "another source": [*cells[:3], cells[3].replace("Ricci", "Rossi"), *cells[4:]],
    }
    for name, other in changed.items():
        code, said = run("--check", "--page", page_with(text.replace(row, " | ".join(other))), table="heart")
        check(code == 1 and what in said, f"{name}: {code}, {said}")
    for what in ("tricuspid annulus, lesser and greater diameter", "places outside the blood on the 4 ways from a vena cava to a "
                 "pulmonary artery"):
        code, said = run("--check", "--page", page_with(text.replace(row_of(text, what) + "\n", "")), table="heart")
        check(code == 1 and f"is not on the page: {what}" in said, f"no row: {code}, {said}")


shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
code, said = run("--check", table="heart")
check(code == 0, "resources/scripts/held_table.py BUILD_DIRECTORY --write makes the tables:\n" + said)
test_ranges((source / "docs/sample_organs.md").read_text(encoding="utf-8"))
code, said = run("--check")
check(code == 0, "resources/scripts/held_table.py BUILD_DIRECTORY --write makes the tables:\n" + said)
test_differences(PAGE.read_text(encoding="utf-8"))
test_measurements(PAGE.read_text(encoding="utf-8"))
