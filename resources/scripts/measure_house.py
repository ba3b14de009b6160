#!/usr/bin/env python3
"""measure_house.py [SOURCE_DIRECTORY] [--json] [--verbose]

Counts in the sources what docs/architecture.md promises, so that two states of the tree can be compared. It reads text and
builds nothing; paths are printed relative to the tree.

  modules          folders of modules/, nested ones (modules/motion/heart) not counted
  arrows           pairs (module, other module whose header it includes); app and tests not counted
  arrows in cycles those from which a way leads back
  arrows upward    those to a module of a higher stratum (STRATUM in the modules' CMakeLists.txt); "-" before strata were stated
  casts            dynamic_casts to a class derived from sequences::Sequence, outside the module that defines it
  organ names      files that decide by a name what an organ is, outside norms and anatomy: two different words for organs or
                   chambers are compared, searched for, or begin rows of a table. Translated texts and comments do not count
  colours          of a liver: colours that stand beside the word, also in the definitions of sample organs; groups of
                   handles not counted
  texts            <source> in names_de.ts and viscera_de.ts
  long files       above 600 lines;  long functions: above 80 lines; both in app and modules
  window           headers of app/window that one file includes, the source of the same name not counted; its QObjects without
                   a widget: classes that derive from QObject itself, in files without one of Qt's widgets; its folders in a
                   knot: those from which includes lead to another folder and back
  lines            of .h and .cpp in app and modules
  comments         share of the lines of .cpp that hold nothing but a comment, in per mille; lines of the median block
  dangling         blocks of comments that open with a preposition or pronoun whose subject stands elsewhere
"""
import argparse
import json
import pathlib
import re
import statistics
import sys

MOST_LINES_OF_FILE, MOST_LINES_OF_FUNCTION = 600, 80
STRATA = ["numbers", "content", "work", "faces"]
CHAMBERS = ["LV", "RV", "LA", "RA"] # Small ones are ids of sample organs and of the circulation.
ORGANS = """heart ventricle atrium ventric atri myocard myocardium epicard endocard liver hepat hepar spleen kidney
  renal stomach gastr pancreas pancrea gallbladder gall bladder bowel intestin colon duoden duodenum lung brain aorta arter artery
  vein cava muscle""".split()
DANGLING = """of in as from for with without by at on to over under than
  it its they their them those these this that which whose who he she such""".split()
WIDGETS = """Widget Dialog Button Box Label Layout Menu Action Bar View Edit Slider Splitter Window Shortcut ToolTip Style Delegate Frame
  Completer Application""".split()
LITERAL = r'"((?:[^"\\\n]|\\.)*)"'


def without_comments(text):
    """The text with comments blanked; literals and line numbers stay."""
    def blank(found):
        return found[0] if found[0][0] in "\"'" else re.sub(r"[^\n]", " ", found[0])
    return re.sub(r'R"\w*\(.*?\)\w*"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'|//[^\n]*|/\*.*?\*/', blank, text, flags=re.S)


class Tree:
    """The sources of app and modules, each read once."""

    def __init__(self, root):
        self.root = root
        self.modules = sorted(f.name for f in (root / "modules").iterdir() if f.is_dir())
        self.files, self.written = {}, {} # Without and with comments.
        for top in ("app", "modules"):
            for file in sorted((root / top).rglob("*")):
                if file.suffix in (".h", ".cpp"):
                    text = file.read_text(encoding="utf-8", errors="replace")
                    self.written[file.relative_to(root)] = text
                    self.files[file.relative_to(root)] = without_comments(text)
        # "sequences" -> "motion" where the headers viscera/sequences/... lie in a folder of the module motion.
        self.owner = {}
        for folder in (root / "modules").rglob("include/viscera/*"):
            self.owner[folder.name] = folder.relative_to(root / "modules").parts[0]

    def module_of(self, file):
        return file.parts[1] if file.parts[0] == "modules" else None


def arrows(tree):
    found = set()
    for file, text in tree.files.items():
        module = tree.module_of(file)
        for name in re.findall(r'^\s*#\s*include\s*[<"]viscera/(\w+)/', text, flags=re.M):
            target = tree.owner.get(name, name)
            if module and target != module:
                found.add((module, target))
    return sorted(found)


def reachable(pairs, start):
    seen, open_ends = set(), [start]
    while open_ends:
        at = open_ends.pop()
        for source, target in pairs:
            if source == at and target not in seen:
                seen.add(target)
                open_ends.append(target)
    return seen


def strata(tree):
    """The stratum of each module, the highest of its folders; empty when one has none."""
    found = {}
    for file in (tree.root / "modules").rglob("CMakeLists.txt"):
        parts = file.relative_to(tree.root / "modules").parts
        for stratum in re.findall(r"\bSTRATUM (\w+)", file.read_text(encoding="utf-8")) if len(parts) > 1 else []:
            if stratum in STRATA:
                found[parts[0]] = max(found.get(parts[0], 0), STRATA.index(stratum))
    return found


def casts(tree):
    """(file, class) of each cast to a class derived from Sequence, in other modules than the one that defines it."""
    derived, defined_in = {"Sequence"}, {}
    classes = [(file, name, base) for file, text in tree.files.items()
               for name, base in re.findall(r"^\s*class (\w+)(?: final)? : public ([\w:]+)", text, flags=re.M)]
    for _ in classes:
        for file, name, base in classes:
            if base.split("::")[-1] in derived and name not in derived:
                derived.add(name)
                defined_in[name] = file
    found = []
    for file, text in tree.files.items():
        for target in re.findall(r"dynamic_cast<\s*(?:const\s+)?([\w:]+)", text):
            name = target.split("::")[-1]
            if name in defined_in and file.parts[:2] != defined_in[name].parts[:2]:
                found.append((str(file), name))
    return found


def deciding_words(text):
    """The words for organs that are compared, searched for, or begin a row of a table in this text."""
    text = re.sub(r"\b(?:tr|translate|QT_TR\w*_NOOP)\((?:" + LITERAL + r"[,\s]*)+\)", "()", text)
    words = set()
    for found in re.finditer(LITERAL, text):
        if found[1] not in CHAMBERS and found[1].lower() not in ORGANS:
            continue
        before, after = text[:found.start()].rstrip(), text[found.end():].lstrip()
        compared = before.endswith(("==", "!=")) or after.startswith(("==", "!="))
        searched = re.search(r"\b(?:has|contains|find|count|startsWith|starts_with|word\w*)\((?:[\w.:]+,\s*)?$", before)
        row = before.endswith("{") and after.startswith(",")
        if compared or searched or row:
            words.add(found[1].lower())
    return words


def naming_files(tree):
    return [str(file) for file, text in tree.files.items()
            if tree.module_of(file) not in ("norms", "anatomy") and len(deciding_words(text)) > 1]


def colours_of(organ, tree):
    """(colour, file) of each colour beside the organ's name, as three numbers from 0 to 255."""
    number = r"\s*(-?\d+(?:\.\d+)?)\s*"
    colour = re.compile(rf'"#([0-9a-fA-F]{{6}})"|\b0x([0-9a-fA-F]{{6}})\b|[\[{{(]{number},{number},{number}[\]}})]')
    found = set()
    texts = dict(tree.files)
    for file in sorted((tree.root / "sample_organs").glob("*.json")):
        texts[file.relative_to(tree.root)] = file.read_text(encoding="utf-8")
    for file, text in texts.items():
        for name in re.finditer(rf'"{organ}"|\bOrgan::{organ}\b', text, flags=re.I):
            row = re.split(r"[;\n]", text[name.end():name.end() + 160])[0]
            met = colour.search(re.split(rf'\}},\s*\{{"', row)[0])
            if not met or "HandleGroup" in text[text.rfind(";", 0, name.start()) + 1:name.start()]:
                continue
            digits = met[1] or met[2]
            if digits:
                values = tuple(int(digits[i:i + 2], 16) for i in (0, 2, 4))
            else:
                values = [float(v) for v in met.group(3, 4, 5)]
                if min(values) < 0 or max(values) > 255:  # A place in mm.
                    continue
                values = tuple(round(v * 255) if max(values) <= 1 else round(v) for v in values)
            found.add((values, str(file)))
    return sorted(found)


def functions(text):
    """(first line, number of lines) of each function, by the braces of formatted code."""
    quiet = re.sub(r'R"\w*\(.*?\)\w*"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'',
                   lambda m: re.sub(r"[^\n]", "x", m[0]), text, flags=re.S)
    quiet = re.sub(r"^\s*#.*(?:\\\n.*)*$", lambda m: re.sub(r"[^\n]", " ", m[0]), quiet, flags=re.M)
    kinds, head_from, found = [], 0, []
    for at in re.finditer(r"[{};]", quiet):
        outside = all(kind in ("namespace", "type") for kind, _ in kinds)
        if at[0] == "{":
            head = quiet[head_from:at.start()]
            if outside and re.match(r"\s*(?:inline )?namespace\b|\s*extern x+\s*$", head):
                kind = "namespace"
            elif outside and re.search(r"\)[^()=]*\s$|\)\s*:.*\)\s$", head, flags=re.S) and "=" not in head.rsplit(")", 1)[-1]:
                kind = "function"
            elif outside and re.search(r":.*[})]\s$", head, flags=re.S) and "(" in head:
                kind = "function" # Its last member is initialised in braces.
            elif outside and re.search(r"\b(?:class|struct|union|enum)\b", head):
                kind = "type"
            else:
                kind = "other"
            kinds.append((kind, head_from + len(head) - len(head.lstrip())))
            if kind != "other" or not outside:
                head_from = at.end()
        elif at[0] == "}":
            kind, begin = kinds.pop() if kinds else ("other", 0)
            if kind == "function":
                found.append((quiet.count("\n", 0, begin) + 1, quiet.count("\n", begin, at.start()) + 1))
            if kind != "other" or not all(k in ("namespace", "type") for k, _ in kinds):
                head_from = at.end()
        else:
            head_from = at.end()
    return found


def in_window(tree):
    """The files of app/window with what they include of it."""
    found = {}
    for file, text in tree.files.items():
        names = re.findall(r'^\s*#\s*include\s*"(window/[^"]+)"', text, flags=re.M)
        found[file] = [pathlib.Path("app") / name for name in names]
    return found


def single_user_headers(tree):
    """(header, its one includer) in app/window; a source of the header's own name is no includer."""
    users = {file: [] for file in tree.files if file.parts[:2] == ("app", "window") and file.suffix == ".h"}
    for file, included in in_window(tree).items():
        for header in included:
            if header in users and file.with_suffix("") != header.with_suffix(""):
                users[header].append(file)
    return [f"{header} <- {files[0]}" for header, files in users.items() if len(files) == 1]


def objects_without_widget(tree):
    """Classes that derive from QObject itself, where neither header nor source includes one of Qt's widgets."""
    widget = re.compile(r"^\s*#\s*include\s*<Q\w*(?:" + "|".join(WIDGETS) + r")\w*>", flags=re.M)
    return [f"{file} {name}" for file, text in tree.files.items() if file.parts[:2] == ("app", "window")
            and not any(widget.search(tree.files.get(file.with_suffix(suffix), "")) for suffix in (".h", ".cpp"))
            for name in re.findall(r"^\s*class (\w+)(?: final)?\s*:[^{;]*\bpublic QObject\b", text, flags=re.M)]


def folders_in_knots(tree):
    """Folders of app/window from which includes lead to another folder and back."""
    pairs = {(str(file.parent), str(header.parent)) for file, included in in_window(tree).items()
             if file.parts[:2] == ("app", "window") for header in included if file.parent != header.parent}
    return sorted({source for source, target in pairs if source in reachable(pairs, target)})


def comment_blocks(tree):
    """(file, first line, its lines) of each block of comments that stands on lines of its own."""
    found = []
    for file, text in tree.written.items():
        block = []
        for number, line in enumerate(text.split("\n") + [""], start=1):
            if line.lstrip().startswith("//"):
                block.append(line.strip())
            elif block:
                found.append((file, number - len(block), block))
                block = []
    return found


def dangles(block):
    """Whether a block opens with a word whose subject stands elsewhere."""
    first = re.match(r"//[/!]?<?\s*([A-Z][a-z]*)\b", block[0])
    return bool(first) and first[1].lower() in DANGLING


def measure(root):
    tree = Tree(root)
    blocks = comment_blocks(tree)
    in_sources = [len(block) for file, _, block in blocks if file.suffix == ".cpp"]
    source_lines = sum(text.count("\n") for file, text in tree.written.items() if file.suffix == ".cpp")
    dangling = [f"{file}:{line} {block[0]}" for file, line, block in blocks if dangles(block)]
    pairs = arrows(tree)
    levels = strata(tree)
    known = all(module in levels for pair in pairs for module in pair)
    upward = [pair for pair in pairs if known and levels[pair[1]] > levels[pair[0]]]
    cyclic = [pair for pair in pairs if pair[0] in reachable(pairs, pair[1])]
    texts = {name: (root / "resources/translations" / name).read_text(encoding="utf-8").count("<source>")
             for name in ("names_de.ts", "viscera_de.ts")}
    liver = colours_of("liver", tree)
    lengths = {str(file): text.count("\n") for file, text in tree.files.items()}
    long_functions = [(f"{file}:{line}", length) for file, text in tree.files.items()
                      for line, length in functions(text) if length > MOST_LINES_OF_FUNCTION]
    translator = [str(file) for file in tree.files if file.stem == "phrase_translator"]
    return [  # title, number, what was counted
        ("modules", len(tree.modules), tree.modules),
        ("arrows between modules", len(pairs), [" -> ".join(pair) for pair in pairs]),
        ("arrows in cycles", len(cyclic), [" -> ".join(pair) for pair in cyclic]),
        ("arrows upward", len(upward) if known else None, [" -> ".join(pair) for pair in upward]),
        ("casts to a concrete sequence", len(casts(tree)), [" ".join(cast) for cast in casts(tree)]),
        ("files that know organs by their name", len(naming_files(tree)), naming_files(tree)),
        ("colours of a liver", len({colour for colour, _ in liver}), [f"{colour} {file}" for colour, file in liver]),
        ("translated texts", sum(texts.values()), [f"{name} {count}" for name, count in texts.items()]),
        ("files of PhraseTranslator", len(translator), translator),
        ("functions", sum(len(functions(text)) for text in tree.files.values()), []),
        ("functions too long", len(long_functions), [f"{place} {length} lines" for place, length in long_functions]),
        ("files", len(lengths), []),
        ("files too long", sum(n > MOST_LINES_OF_FILE for n in lengths.values()),
         [f"{file} {n} lines" for file, n in lengths.items() if n > MOST_LINES_OF_FILE]),
        ("lines", sum(lengths.values()), []),
        ("headers of the window with one includer", len(single_user_headers(tree)), single_user_headers(tree)),
        ("objects of the window without a widget", len(objects_without_widget(tree)), objects_without_widget(tree)),
        ("folders of the window in a knot", len(folders_in_knots(tree)), folders_in_knots(tree)),
        ("comments in sources, per mille of lines", round(1000 * sum(in_sources) / max(source_lines, 1)), []),
        ("lines of the median comment in sources", statistics.median_low(in_sources) if in_sources else 0, []),
        ("comments that open without their subject", len(dangling), dangling),
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--json", action="store_true", help="print the numbers as one JSON object")
    parser.add_argument("--verbose", action="store_true", help="list what was counted")
    options = parser.parse_args()
    if not (options.source / "modules").is_dir():
        sys.exit("There is no folder 'modules' in the given directory; name the top of a checkout.")
    rows = measure(options.source)
    if options.json:
        print(json.dumps({title: number for title, number, _ in rows}, indent=2))
        return
    for title, number, counted in rows:
        print(f"{title:42} {'-' if number is None else number:>6}")
        for line in counted if options.verbose else []:
            print(f"    {line}")


main()
