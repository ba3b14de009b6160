"""measure_house_test.py SOURCE_DIRECTORY WORK_DIRECTORY: measure_house.py counts what is known of a small tree, and runs here."""
import json
import pathlib
import shutil
import subprocess
import sys

source, work = map(pathlib.Path, sys.argv[1:])
SCRIPT = source / "resources/scripts/measure_house.py"

FILES = {
    "app/main.cpp": 'int main() {\n  return name == "liver" || "LV" == name;\n}\n',
    "app/window/panel.h": '#include <QWidget>\nclass Panel final : public QObject {\n};\n',
    "app/window/a/model.h": '#include "window/b/part.h"\n/// Of the model.\nclass Model : public Base, public QObject {\n};\n',
    "app/window/b/part.h": '#include "window/a/model.h"\n',
    "app/window/b/part.cpp": '#include "window/b/part.h"\n#include "window/panel.h"\n// A part.\n// It draws.\n',
    "modules/core/CMakeLists.txt": "viscera_module(core STRATUM numbers)\n",
    "modules/core/include/viscera/core/arrays.h": '#include "viscera/scene/actor.h"\n',
    "modules/motion/heart/CMakeLists.txt": "viscera_module(heart STRATUM numbers)\n",
    "modules/motion/heart/include/viscera/heart/beat.h":
        '#include "viscera/core/arrays.h"\nclass Beat final : public sequences::Sequence {\n};\n',
    "modules/motion/heart/src/beat.cpp": "void f() { dynamic_cast<const Beat*>(own); }\n",
    "modules/scene/CMakeLists.txt": "viscera_module(scene STRATUM faces)\n",
    "modules/scene/include/viscera/scene/actor.h": '#include "viscera/heart/beat.h" // "heart" {"liver", "LV"}\n',
    "modules/scene/src/actor.cpp":
        'Row rows[] = {{"liver", {10, 20, 30}}, {"spleen", "#ffffff"}};\nvoid Actor::draw() const {\n' + "  go();\n" * 90 +
        "  dynamic_cast<const heart::Beat*>(sequence);\n}\n",
    "resources/translations/names_de.ts": "<source>a</source>\n",
    "resources/translations/viscera_de.ts": "<source>b</source>\n<source>c</source>\n",
    "sample_organs/liver.json": '{"organ": "Liver", "color": [0.5, 0.2, 0.16]}\n',
}
EXPECTED = {
    "modules": 3, "arrows between modules": 3, "arrows in cycles": 3, "arrows upward": 1, "casts to a concrete sequence": 1,
    "files that know organs by their name": 2, "colours of a liver": 2, "translated texts": 3, "files of PhraseTranslator": 0,
    "functions": 3, "functions too long": 1, "files": 10, "files too long": 0,
    "lines": 115, "headers of the window with one includer": 3, "objects of the window without a widget": 1,
    "folders of the window in a knot": 2, "comments in sources, per mille of lines": 20,
    "lines of the median comment in sources": 2, "comments that open without their subject": 1,
}


def measured(tree):
    return json.loads(subprocess.run([sys.executable, SCRIPT, tree, "--json"], check=True, capture_output=True, text=True).stdout)


def check(condition, message):
    if not condition:
        sys.exit(message)


shutil.rmtree(work, ignore_errors=True)
for name, text in FILES.items():
    (work / name).parent.mkdir(parents=True, exist_ok=True)
    (work / name).write_text(text, encoding="utf-8")
small = measured(work)
check(small == EXPECTED, f"the small tree: {small}")

house = measured(source)
folders = sum(folder.is_dir() for folder in (source / "modules").iterdir())
check(house["modules"] == folders, f"{house['modules']} modules of {folders} folders")
check(house["arrows in cycles"] == 0 and house["arrows upward"] == 0, f"arrows that point upward: {house}")
check(house["functions"] > 5000 and house["files"] > 1000, f"most of the house was not read: {house}")
text = subprocess.run([sys.executable, SCRIPT, source, "--verbose"], check=True, capture_output=True, text=True).stdout
check(str(source) not in text, "the script prints where the tree is on this machine")
