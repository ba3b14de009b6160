#!/usr/bin/python3
"""Opens a lesson in a browser and checks it against what the program says of it (docs/lessons.md).

Usage: check_page.py LESSON.html TRUTH.json [--browser firefox] [--reference FILE.json] [--pictures FOLDER]
TRUTH.json is written by lesson_page_test.cpp; VISCERA_UPDATE_PICTURES=1 writes the reference instead of comparing with
it. Exit status 0: all checks passed."""
import argparse, json, os, pathlib, sys, time

from chromium import Chromium
from firefox import Firefox
from png import blocks

VERTEX_MM, VOLUME, DRAG_MM = 0.05, 5e-4, 0.05
failed = []


def check(name, good, detail=""):
    if not good:
        failed.append(name)
    print("passed" if good else "FAILED", name, str(detail)[:400])


def largest(found, expected):
    return max([0] + [sum((a - b) ** 2 for a, b in zip(f, e)) ** 0.5 for f, e in zip(found, expected)])


def points_now(b, vertices):
    return b.run(f"{json.dumps(vertices)}.map(v => viscera.placeOf(v))")


def check_numbers(b, truth):
    worst = worst_volume = 0
    for instant in truth["instants"]:
        b.run(f"viscera.setRate({instant['rate']}), viscera.seek({instant['fraction']}), viscera.render()")
        worst = max(worst, largest(points_now(b, truth["vertices"]), instant["points"]))
        for found, expected in zip(b.run("viscera.volumes()"), instant["volumesMl"]):
            worst_volume = max(worst_volume, abs(found - expected) / abs(expected) if expected else 0)
    check("vertices are the program's", worst < VERTEX_MM, f"{worst:.4f} mm over {len(truth['instants'])} instants")
    check("volumes are the program's", worst_volume < VOLUME, f"{100 * worst_volume:.4f} %")


def check_drag(b, truth):
    drag = truth.get("drag", {"handle": 8, "by": [9, -12, 4]})
    b.run("viscera.setRate(viscera.lesson.motion ? viscera.lesson.motion.rate : 0), viscera.seek(0.2), viscera.render()" if truth["moves"] else "viscera.render()")
    before, volumes = points_now(b, truth["vertices"]), b.run("viscera.volumes()")
    b.run(f"viscera.pull({drag['handle']}, {drag['by']}), viscera.render()")
    if "moved" in drag:
        moved = [[x - y for x, y in zip(p, q)] for p, q in zip(points_now(b, truth["vertices"]), before)]
        check("a pull moves what the binding moves", largest(moved, drag["moved"]) < DRAG_MM, f"{largest(moved, drag['moved']):.4f} mm")
    check("a pull changes a volume", any(abs(x - y) > 0.02 for x, y in zip(volumes, b.run("viscera.volumes()"))))
    if truth["moves"] and b.run("viscera.surfaces.some(s => s.ejects)"):
        check("the pulled beat's ejection fraction is said", "without handles" in b.run("document.getElementById('indices').textContent"))
    check("reset is to the bit", b.run("viscera.reset(), viscera.render(), viscera.volumes()") == volumes)


def visible_handle(b):
    """A handle that nothing of the page covers: its number and where it is."""
    return b.run("""(() => { viscera.showHandles(true); viscera.render(); const box = document.getElementById('view').getBoundingClientRect();
        const at = viscera.handles.map((h, i) => [i, ...viscera.project(viscera.placeOf(h.vertex))]).map(([i, x, y]) => [i, x + box.x, y + box.y]);
        return at.find(([i, x, y]) => document.elementFromPoint(x, y) === document.getElementById('view')
          && at.every(([j, u, v]) => j === i || Math.hypot(u - x, v - y) > 30)); })()""")


def check_hands(b, touch):
    handle, x, y = visible_handle(b)
    volumes = b.run("viscera.volumes()")
    path = [(x, y), (x + 15, y - 10), (x + 40, y - 25)]
    b.touch(path) if touch else b.mouse(path)
    b.run("viscera.render()")
    name = "a finger" if touch else "the mouse"
    pull = b.run(f"viscera.handles[{handle}].pull")
    check(name + " drags a handle", sum(abs(v) for v in pull) > 1, pull)
    check(name + "'s drag changes the volumes", b.run("viscera.volumes()") != volumes)
    b.run("viscera.reset(), viscera.showHandles(false), viscera.render()")
    yaw = b.run("viscera.camera.yaw")
    # No handle is shown now, so that one may begin anywhere.
    x, y = b.run("(r => [r.x + r.width / 2, r.y + r.height / 2])(document.getElementById('view').getBoundingClientRect())")
    path = [(x, y), (x + 30, y), (x + 60, y + 5)]
    b.touch(path) if touch else b.mouse(path)
    check(name + " turns the picture", abs(b.run("viscera.camera.yaw") - yaw) > 0.2)
    if touch:
        zoom = b.run("viscera.camera.zoom")
        b.touch([(x, y), (x - 10, y), (x - 20, y)], [(x + 60, y), (x + 75, y), (x + 95, y)])
        check("two fingers come nearer", b.run("viscera.camera.zoom") > 1.2 * zoom)
    b.run("viscera.setSide('anterior'), viscera.render()")


def check_keys(b, truth):
    b.run("document.getElementById('view').focus(), viscera.setPlaying(false), viscera.render()")
    b.key("PageDown")
    check("a key chooses a handle", b.run("viscera.state.held") == 0)
    check("the chosen handle is said", b.run("document.getElementById('held').textContent").strip() != "")
    volumes = b.run("viscera.render(), viscera.volumes()")
    for _ in range(3):
        b.key("ArrowRight", shift=True)
    check("keys move a handle", b.run("viscera.render(), viscera.volumes()") != volumes and sum(abs(x) for x in b.run("viscera.handles[0].pull")) > 20)
    b.key("Escape")
    b.key("r")
    check("keys put it back", b.run("viscera.render(), viscera.volumes()") == volumes)
    yaw = b.run("viscera.camera.yaw")
    b.key("ArrowLeft")
    check("keys turn the picture", b.run("viscera.camera.yaw") != yaw)
    if truth["moves"]:
        b.key(" ")
        check("space plays", b.run("viscera.state.playing") is True)
        b.key(" ")
        b.run("document.activeElement.blur(), viscera.seek(0.5), viscera.render()")
        b.key("ArrowRight")
        check("keys go through the cycle", abs(b.run("viscera.state.fraction") - 0.52) < 1e-9)
    b.run("viscera.setSide('anterior'), viscera.showHandles(false), viscera.render()")


def check_picture(b):
    counts = b.run("""[1, 2].map(n => { for (let i = 0; i < n; ++i) { viscera.seek(0.2); viscera.render(); }
        const g = viscera.gl, w = g.canvas.width, h = g.canvas.height, p = new Uint8Array(4 * w * h);
        g.readPixels(0, 0, w, h, g.RGBA, g.UNSIGNED_BYTE, p); return p.reduce((sum, v, i) => sum + (i % 4 === 3 && v > 20), 0) / (w * h); })""")
    check("the organ fills a part of the picture", 0.05 < counts[0] < 0.9, counts)
    check("drawn twice is drawn once", counts[0] == counts[1], counts)
    sum_of = """(() => { viscera.render(); const g = viscera.gl, w = g.canvas.width, h = g.canvas.height, p = new Uint8Array(4 * w * h);
        g.readPixels(0, 0, w, h, g.RGBA, g.UNSIGNED_BYTE, p); return p.reduce((sum, v) => sum + v, 0); })()"""
    shown = b.run(sum_of)
    hidden = b.run("document.querySelector('.tile button').click(), " + sum_of)
    check("an eye hides its organ", hidden < 0.9 * shown, (shown, hidden))
    check("an eye brings it back", b.run("document.querySelector('.tile button').click(), " + sum_of) == shown)


def check_reference(b, reference):
    """Holds the picture against one that somebody has looked at."""
    b.window(500, 500)
    # What has texts differs from browser to browser.
    show = "document.querySelectorAll('header, #slides, #panel, footer, #tools').forEach(e => { e.style.display = '%s'; })"
    b.run(show % "none")
    time.sleep(0.3)
    b.run("viscera.setSide('anterior'), viscera.showNames(false), viscera.seek(0.3), viscera.render()")
    box = b.run("(r => [r.left, r.top, r.right, r.bottom].map(Math.round))(document.getElementById('stage').getBoundingClientRect())")
    means = [[round(c) for c in block] for block in blocks(b.picture(), box)]
    if os.environ.get("VISCERA_UPDATE_PICTURES") == "1":
        reference.write_text(json.dumps(means, separators=(",", ":")) + "\n")
    if reference.exists():
        expected = json.loads(reference.read_text())
        off = [max(abs(x - y) for x, y in zip(p, q)) for p, q in zip(means, expected)]
        check("the picture is its reference", len(means) == len(expected) and sum(v > 24 for v in off) < 0.02 * len(off), f"{sum(v > 24 for v in off)} of {len(off)} blocks differ")
    else:
        check("the picture has a reference", False, f"look at it, then write {reference} with VISCERA_UPDATE_PICTURES=1")
    b.run("viscera.showNames(true), " + show % "")
    b.window(1280, 800)
    time.sleep(0.3)


OVERLAPS = """(() => {
  viscera.render();
  const shown = e => { const r = e.getBoundingClientRect(), s = getComputedStyle(e); return r.width > 1 && r.height > 1 && s.visibility !== 'hidden'; };
  const groups = ['header > *', '#tools > *, .name, #slides, #held:not(:empty)', '#transport > *, #chart', '.tile', '#panel > *', '#quiz > *'];
  const found = [];
  for (const group of groups) {
    const list = [...document.querySelectorAll(group)].filter(shown), boxes = list.map(e => e.getBoundingClientRect());
    for (let i = 0; i < list.length; ++i) {
      if (group[0] !== '.' && group !== '#panel > *' && (boxes[i].left < -0.5 || boxes[i].right > innerWidth + 0.5)) found.push(['outside', list[i].id || list[i].textContent.slice(0, 30)]);
      for (let j = 0; j < i; ++j) {
        const a = boxes[i], b = boxes[j];
        if (a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1)
          found.push([list[j].id || list[j].textContent.slice(0, 30), list[i].id || list[i].textContent.slice(0, 30)]);
      }
    }
  }
  if (document.documentElement.scrollWidth > innerWidth) found.push(['wider than the window', document.documentElement.scrollWidth]);
  return found; })()"""


def check_layout(b, name, slides=True):
    found = b.run(OVERLAPS)
    check(f"nothing overlaps, {name}", not found, found)
    if slides:
        for _ in range(b.run("viscera.lesson.slides.length")):
            b.run("document.getElementById('after').click()")
            found = b.run(OVERLAPS)
            check(f"nothing overlaps, {name}, " + b.run("document.getElementById('slideTitle').textContent")[:24], not found, found)
        b.run("viscera.setPlaying(false), viscera.showNames(true), viscera.setSide('anterior')")


def check_quiz(b, truth):
    if not b.run("!document.getElementById('ask').hidden"):
        check("a quiz is offered", not truth["quiz"])
        return
    asked = set()
    b.run("document.getElementById('ask').click(), viscera.render()")
    check("names are hidden in the quiz", b.run("getComputedStyle(document.getElementById('names')).visibility === 'hidden'"))
    for i in range(6):
        asked.add(b.run("document.getElementById('question').textContent"))
        check(f"question {i + 1} has an answer", b.run("viscera.quiz.answer >= 0 && document.getElementById('choices').children.length > 1"))
        wrong = i == 1
        b.run("(c => c[%s].click())(document.getElementById('choices').children)" % ("(viscera.quiz.answer + 1) % c.length" if wrong else "viscera.quiz.answer"))
        check(f"answer {i + 1} is judged", b.run("document.getElementById('verdict').textContent").startswith("No" if wrong else "Right"))
        b.run("document.getElementById('next').click()")
    check("the quiz counts", "5 of 6" in b.run("document.getElementById('question').textContent"), b.run("document.getElementById('question').textContent"))
    check("the quiz asks what there is to ask", len(asked) == truth["quiz"], asked)
    check("nothing is kept", b.run("document.cookie === '' && (() => { try { return localStorage.length; } catch (e) { return 0; } })() === 0"))
    b.run("document.getElementById('leave').click(), viscera.setSide('anterior'), viscera.render()")
    check("the quiz is left", b.run("document.getElementById('quiz').hidden && !document.getElementById('panel').hidden"))


def check_texts(b, truth):
    whole = b.run("document.body.textContent")
    for text in truth["texts"]:
        check("stays text: " + text[:24].replace("\n", " "), text in whole)
    check("the title is the title", b.run("document.title").strip() == " ".join(truth["title"].split()) and b.run("document.getElementById('title').textContent") == truth["title"])
    check("no element came with a text", b.run("document.scripts.length === 3 && !document.querySelector('img, iframe, object, embed, svg, link, a') && window.hostile === undefined"))
    nameless = b.nameless()
    check("everything to grip has a name", not nameless, nameless)


def take_pictures(b, folder):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for name, size in (("wide", (1280, 800, 1, False)), ("phone", (390, 844, 2, True))):
        b.window(*size)
        time.sleep(0.4)
        for light in (False, True):
            b.run(f"viscera.setLight({json.dumps(light)}), viscera.showNames(true), viscera.setSide('anterior'), viscera.seek(0.3), viscera.render()")
            b.picture(f"{folder}/{name}_{'light' if light else 'dark'}.png")
        b.run("viscera.setLight(false), viscera.showHandles(true), viscera.pull(3, [9, -12, 4]), viscera.render(), viscera.render()")
        b.picture(f"{folder}/{name}_handles.png")
        b.run("viscera.reset(), viscera.showHandles(false), document.getElementById('ask').click(), viscera.render()")
        b.picture(f"{folder}/{name}_quiz.png")
        b.run("document.getElementById('leave').click()")
    b.run("viscera.setSide('anterior'), viscera.render()")
    b.window(1280, 800)


def main(arguments):
    truth = json.loads(pathlib.Path(arguments.truth).read_text())
    b = Firefox() if arguments.browser == "firefox" else Chromium()
    try:
        b.window(1280, 800)
        b.prefer(motion="no-preference", scheme="light")
        b.open(arguments.lesson)
        check("it plays by itself", b.run("viscera.state.playing") is truth["moves"])
        check("it is light as the system is", b.run("document.documentElement.className") == "light")
        b.prefer()
        ready = b.open(arguments.lesson)
        print("ready after", ready, "ms")
        check("it stands still for who wants that", b.run("viscera.state.playing") is False)
        check("it is dark as the system is", b.run("document.documentElement.className") == "")
        if truth["moves"]:
            check_numbers(b, truth)
        if truth.get("measurements"):
            found = b.run("viscera.render(), viscera.measures()")
            check("measurements are the program's", all(abs(x - y) < 0.1 for x, y in zip(found, truth["measurements"])), found)
        check_texts(b, truth)
        if arguments.pictures:
            take_pictures(b, arguments.pictures)
        if truth["whole"]:
            check_drag(b, truth)
            check_picture(b)
            check_hands(b, touch=False)
            check_keys(b, truth)
            check_quiz(b, truth)
        if arguments.reference:
            check_reference(b, pathlib.Path(arguments.reference))
        check_layout(b, "1280 wide", slides=False)
        b.window(390, 844, 2, True)
        time.sleep(0.5)
        if truth["whole"]:
            check_hands(b, touch=True)
            b.run("document.getElementById('ask').hidden || document.getElementById('ask').click()")
            check_layout(b, "390 wide, quiz", slides=False)
            b.run("document.getElementById('ask').hidden || document.getElementById('leave').click()")
        check_layout(b, "390 wide")
        check("nothing but the file was asked for", not b.asked_for(), b.asked_for())
        check("nothing is said on the console", not b.said(), json.dumps(b.said()))
        check("the policy refuses the network", b.run("fetch('https://example.org/').then(() => 'open', e => 'refused')") == "refused")
        check("the policy refuses other scripts", b.run("(() => { const s = document.createElement('script'); s.textContent = 'window.hostile = 1'; document.head.append(s); return window.hostile; })()") is None)
    finally:
        b.end()
    print(f"{len(failed)} failed: {failed}" if failed else "all passed")
    return 1 if failed else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lesson")
    parser.add_argument("truth")
    parser.add_argument("--browser", choices=("chromium", "firefox"), default="chromium")
    parser.add_argument("--reference")
    parser.add_argument("--pictures")
    sys.exit(main(parser.parse_args()))
