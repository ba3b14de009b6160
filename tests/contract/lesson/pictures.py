#!/usr/bin/python3
"""Draws docs/pictures/lessons.png: a heart, a stomach and an organ of a patient as lessons, on a laptop and on a phone, dark and light.

Usage: pictures.py PROGRAM ORGAN [FOLDER], as in: pictures.py build/release/bin/viscera liver.vtk
FOLDER keeps each page with its pictures, those of handles, names and the quiz among them, to be looked at."""
import base64, json, pathlib, subprocess, sys, tempfile, time

from chromium import Chromium

SIZES = {"wide": (1280, 800, 1, False), "phone": (390, 844, 2, True)}
GAP, SCALE = 12, 0.38  # Of the sheet: pixels between pictures, and how much smaller they are.


def take_pictures(b, page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, size in SIZES.items():
        b.window(*size)
        b.open(page)
        time.sleep(0.5)

        def keep(what):
            b.run("viscera.render()")
            time.sleep(0.35)  # What lies behind the organ is looked for three times a second.
            b.run("viscera.render()")
            b.picture(str(folder / f"{name}_{what}.png"))
        for light in (False, True):
            b.run(f"viscera.setLight({json.dumps(light)}), viscera.setSide('anterior'), viscera.seek(0.3)")
            keep("light" if light else "dark")
        b.run("viscera.setLight(false), viscera.showNames(true)")
        keep("names")
        if b.run("viscera.handles.length > 3"):
            b.run("viscera.showHandles(true), viscera.pull(3, [9, -12, 4])")
            keep("handles")
            b.run("viscera.reset(), viscera.showHandles(false)")
        if b.run("!document.getElementById('ask').hidden"):
            b.run("document.getElementById('ask').click()")
            keep("quiz")


def sheet(b, folders, file):
    """All lessons below one another; each row: dark on both screens, light on both."""
    rows = ""
    for folder in folders:
        for light in ("dark", "light"):
            for name, (width, height, _, _) in SIZES.items():
                data = base64.b64encode((folder / f"{name}_{light}.png").read_bytes()).decode()
                rows += f"<img height={round(800 * SCALE)} src='data:image/png;base64,{data}'>"
        rows += "<br>"
    page = folders[0] / "sheet.html"
    page.write_text("<!doctype html><html data-ready=1><style>body{margin:0;background:#888;white-space:nowrap;line-height:0}"
                    f"img{{margin:0 0 {GAP}px {GAP}px}}</style><body style='padding:{GAP}px {GAP}px 0 0;width:max-content'>{rows}</body></html>")
    b.window(3000, 2000)
    b.open(page)
    b.run("Promise.all([...document.images].map(i => i.decode())).then(() => 1)")
    b.window(*b.run("[document.body.offsetWidth, document.body.offsetHeight]"))
    b.picture(str(file))


def main(program, organ, folder):
    lessons = {"heart": ["heartbeat"], "stomach": ["peristalsis"], "patient": ["breathing", "--organ", organ]}
    b = Chromium()
    try:
        for name, what in lessons.items():
            page = folder / name / "lesson.html"
            page.parent.mkdir(parents=True, exist_ok=True)
            subprocess.run([program, "lesson", *what, "-o", str(page)], check=True)
            take_pictures(b, page, page.parent)
        pictures = pathlib.Path(__file__).resolve().parents[3] / "docs/pictures"
        sheet(b, [folder / name for name in lessons], pictures / "lessons.png")
    finally:
        b.end()


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as work:
        main(sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else work))
