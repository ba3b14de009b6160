#!/usr/bin/python3
"""Opens a lesson in a browser and checks it against what the program says of it (docs/lessons.md).

Usage: check_page.py LESSON.html TRUTH.json [--browser firefox] [--reference FILE.json] [--pictures FOLDER]
TRUTH.json is written by lesson_page_test.cpp; VISCERA_UPDATE_PICTURES=1 writes the reference instead of comparing with
it. Exit status 0: all checks passed."""
import argparse, json, math, os, pathlib, sys, time

from chromium import Chromium
from firefox import Firefox
from pictures import take_pictures
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
        check("the pulled beat's ejection fraction is said", beginning(b, "was") in b.run("document.getElementById('indices').textContent"))
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
    b.key("j")
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
    number = "document.getElementById('slideTitle').textContent"
    if b.run("viscera.lesson.slides.length") > 1:
        b.run("viscera.showSlide(0), document.getElementById('after').focus()")
        b.key("PageDown")
        check("a presenter's remote shows the next slide", b.run(number).startswith("2 "), b.run(number))
        b.key("PageUp")
        b.key("PageUp")
        check("the first slide has none before it", b.run(number).startswith("1 "), b.run(number))
    night = "getComputedStyle(document.body, '::after').backgroundColor"
    b.key("b")
    check("a key darkens the screen", b.run(night) == "rgb(0, 0, 0)", b.run(night))
    b.key("Escape")
    check("a key brings the picture back", b.run(night) != "rgb(0, 0, 0)", b.run(night))
    b.run("viscera.setPlaying(false), viscera.setSide('anterior'), viscera.showHandles(false), viscera.render()")


def check_slides(b, slides):
    """The session's slides: in order, with their captions, where they look from, and the instants they name."""
    check("the slides are the session's", b.run("viscera.lesson.slides.map(s => s.title)") == [s["title"] for s in slides])
    for i, slide in enumerate(slides):
        b.run(f"viscera.setPlaying(true), viscera.showSlide({i}), viscera.render()")
        way = [f - p for f, p in zip(slide["focus"], slide["position"])]
        expected = [math.atan2(-way[0], way[1]), math.asin(-way[2] / math.hypot(*way)), *slide["focus"]]
        found = b.run("[viscera.camera.yaw, viscera.camera.pitch, ...viscera.camera.target]")
        check(f"slide {i + 1} looks from where the session does", largest([found], [expected]) < 0.01, found)
        if "fraction" in slide:
            check(f"slide {i + 1} stands at its instant", abs(b.run("viscera.state.fraction") - slide["fraction"]) < 0.001 and not b.run("viscera.state.playing"))
    b.run("viscera.setPlaying(false), viscera.setSide('anterior'), viscera.render()")


def beginning(b, text):
    """What the page's own text begins with, in its language."""
    return b.run(f"viscera.lesson.strings.{text}").split("%")[0].strip()


def check_picture(b):
    counts = b.run("""[1, 2].map(n => { for (let i = 0; i < n; ++i) { viscera.seek(0.2); viscera.render(); }
        const g = viscera.gl, w = g.canvas.width, h = g.canvas.height, p = new Uint8Array(4 * w * h);
        g.readPixels(0, 0, w, h, g.RGBA, g.UNSIGNED_BYTE, p); return p.reduce((sum, v, i) => sum + (i % 4 === 3 && v > 20), 0) / (w * h); })""")
    check("the organ fills a part of the picture", 0.05 < counts[0] < 0.9, counts)
    check("drawn twice is drawn once", counts[0] == counts[1], counts)
    sum_of = """(() => { viscera.render(); const g = viscera.gl, w = g.canvas.width, h = g.canvas.height, p = new Uint8Array(4 * w * h);
        g.readPixels(0, 0, w, h, g.RGBA, g.UNSIGNED_BYTE, p); return p.reduce((sum, v) => sum + v, 0); })()"""
    shown = b.run(sum_of)
    for i in range(b.run("viscera.surfaces.length")):
        # Of an organ behind opaque ones nothing would be missed.
        alone = f"viscera.surfaces.forEach((s, i) => viscera.showSurface(s, i === {i})), "
        eye = f"document.querySelectorAll('.tile button')[{i}].click(), "
        seen, hidden = b.run(alone + sum_of), b.run(eye + sum_of)
        check(f"eye {i + 1} hides its organ and no other", seen > 0 and hidden == 0, (seen, hidden))
    check("eyes bring organs back", b.run("viscera.surfaces.forEach(s => viscera.showSurface(s, false)), document.querySelectorAll('.tile button').forEach(e => e.click()), " + sum_of) == shown)


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
        b.run("viscera.setPlaying(false), viscera.setSide('anterior')")


NAMES = """(() => {
  viscera.render();
  const stage = document.getElementById('stage').getBoundingClientRect(), list = [...document.querySelectorAll('.name')].filter(e => e.getBoundingClientRect().width > 1);
  const controls = [...document.querySelectorAll('header > *, #tools > *, #held:not(:empty), #slides, #panel, footer')].filter(e => e.getBoundingClientRect().width > 1);
  const cross = (e, f) => { const a = e.getBoundingClientRect(), b = f.getBoundingClientRect(); return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom; };
  return {shown: list.length,
    outside: list.filter(e => { const r = e.getBoundingClientRect(); return r.left < stage.left || r.right > stage.right || r.top < stage.top || r.bottom > stage.bottom; }).map(e => e.textContent.slice(0, 30)),
    overlaps: list.flatMap((e, i) => [...list.slice(0, i), ...controls].filter(f => cross(e, f)).map(f => [e.textContent.slice(0, 30), f.id || f.textContent.slice(0, 30)])),
    clipped: list.filter(e => e.scrollWidth > e.clientWidth + 1 || e.scrollHeight > e.clientHeight + 1).map(e => e.textContent.slice(0, 30))}; })()"""


PLACES = """(() => { viscera.render(); const shown = viscera.nameItems.filter(i => i.shown), parts = viscera.nameItems.filter(i => i.part);
  return {hidden: shown.filter(i => viscera.isHidden(i.s, i.seen, i.ring)).map(i => i.text),
    foreign: shown.filter(i => i.seen < i.s.firstVertex || i.seen >= i.s.firstVertex + i.s.vertexCount || !i.part && parts.some(p => p.vertex === i.seen)).map(i => i.text)}; })()"""


def check_short_names(b):
    """Short forms of phases differ, so that no two are the same on a phone."""
    found = b.run("(names => [...new Set(names)].map(t => viscera.shortOf(t, names)))(viscera.lesson.motion ? viscera.lesson.motion.phases.flat().map(p => p[0]) : [])")
    check("short names of phases differ", len(set(found)) == len(found) and "AS" not in found, found)


def check_places(b, truth):
    """From every side, at every phase, on the opaque wall and through it, names shown are seen where their lines end."""
    middles = b.run("viscera.lesson.motion ? viscera.lesson.motion.phases[viscera.state.rate].map(p => (p[1] + p[2]) / 2) : [0]")
    b.run("viscera.setPlaying(false), viscera.showNames(true)")
    for opacity in (1, 0.3):
        for side in ("anterior", "posterior", "left", "right", "superior", "inferior"):
            for fraction in middles[::3]:
                b.run(f"viscera.setGlass({opacity}), viscera.setSide('{side}'), viscera.seek({fraction}), viscera.render()")
                time.sleep(0.35)  # What is seen is looked for three times a second.
                found = b.run(PLACES)
                check(f"names from {side}, {opacity}, at {fraction:.2f} end at their own seen parts", not found["hidden"] and not found["foreign"], found)
    b.run("viscera.setSide('anterior'), viscera.render()")


def check_names(b, truth):
    """On a phone names are hidden at first; who asks for them has them beside one another, clear of all controls."""
    check("a phone shows no names at first", b.run("!viscera.state.names && document.getElementById('labels').getAttribute('aria-pressed') === 'false'"))
    highest = "(() => { let y = 1e9; for (let v = 0; v < viscera.lesson.vertices; v += 7) y = Math.min(y, viscera.project(viscera.placeOf(v))[1]); return y; })()"
    tools = "(t => t.offsetTop + t.offsetHeight)(document.getElementById('tools'))"
    found = b.run(f"viscera.setPlaying(false), viscera.setSide('anterior'), viscera.render(), [{highest}, {tools}]")
    check("a phone shows the organ below the buttons", found[0] > found[1], found)
    b.run("document.getElementById('labels').click()")
    for side in ("anterior", "posterior", "left", "right", "superior", "inferior"):
        b.run(f"viscera.setSide('{side}'), viscera.render()")
        time.sleep(0.35)  # What lies behind the organ is looked for three times a second.
        found = b.run(NAMES)
        check(f"names from {side} overlap nothing", found["shown"] and not found["overlaps"] and not found["outside"], found)
        if not truth.get("hostile"):
            check(f"names from {side} can be read", not found["clipped"], found["clipped"])
    b.run("document.getElementById('labels').click(), viscera.setSide('anterior'), viscera.render()")


ASKABLE = """(() => { const apart = (v, w) => Math.hypot(...[0, 1, 2].map(i => viscera.placeOf(v)[i] - viscera.placeOf(w)[i]));
  const all = viscera.askable(), parts = viscera.nameItems.filter(i => i.part);
  return {names: all.map(a => a.item.text), wrong: all.filter(({item, vertex}) => vertex < item.s.firstVertex || vertex >= item.s.firstVertex + item.s.vertexCount
    || parts.some(p => p !== item && apart(p.vertex, vertex) < (item.part ? apart(item.vertex, vertex) : 1))).map(a => a.item.text)}; })()"""


def check_askable(b):
    """In every phase a name is asked at its own place only: on its surface, and no other name is nearer."""
    middles = b.run("viscera.lesson.motion ? viscera.lesson.motion.phases[viscera.state.rate].map(p => (p[1] + p[2]) / 2) : [0]")
    for fraction in middles:
        found = b.run(f"viscera.seek({fraction}), viscera.render(), {ASKABLE}")
        check(f"names are asked at their own places, at {fraction:.2f}", not found["wrong"], found["wrong"])
        rings = b.run("viscera.nameItems.filter(i => i.ring).map(i => i.text)")
        check(f"every valve can be asked, at {fraction:.2f}", set(rings) <= set(found["names"]), found["names"])


def check_quiz(b, truth):
    if not b.run("!document.getElementById('ask').hidden"):
        check("a quiz is offered", not truth["quiz"])
        return
    asked = set()
    b.run("document.getElementById('ask').click(), viscera.render()")
    check("names are hidden in the quiz", b.run("getComputedStyle(document.getElementById('names')).visibility === 'hidden'"))
    check_askable(b)
    questions = b.run("viscera.quiz.questions")
    for i in range(questions):
        check(f"question {i + 1} stands on the picture", b.run("document.getElementById('stage').contains(document.getElementById('question'))"))
        own = b.run("(q => q.item && [[...document.getElementById('choices').children].map(c => c.textContent).includes(q.item.text), document.getElementById('choices').children[q.answer].textContent === q.item.text])(viscera.quiz)")
        check(f"question {i + 1} has the marked part's name among its choices", own is None or own == [True, True], own)
        asked.add(b.run("document.getElementById('question').textContent"))
        check(f"question {i + 1} has an answer", b.run("viscera.quiz.answer >= 0 && document.getElementById('choices').children.length > 1"))
        wrong = i == 1
        b.run("(c => c[%s].click())(document.getElementById('choices').children)" % ("(viscera.quiz.answer + 1) % c.length" if wrong else "viscera.quiz.answer"))
        check(f"answer {i + 1} is judged", b.run("document.getElementById('verdict').textContent").startswith(beginning(b, "wrongAnswer" if wrong else "rightAnswer")))
        b.run("document.getElementById('next').click()")
    done = b.run("[viscera.lesson.strings.done.replace('%1', viscera.quiz.questions - 1).replace('%2', viscera.quiz.questions), document.getElementById('question').textContent]")
    check("the quiz counts", done[0] == done[1], done)
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


def main(arguments):
    truth = json.loads(pathlib.Path(arguments.truth).read_text())
    b = Firefox() if arguments.browser == "firefox" else Chromium()
    try:
        b.window(1280, 800)
        b.prefer(motion="no-preference", scheme="light")
        b.open(arguments.lesson)
        check("it plays by itself", b.run("viscera.state.playing") is truth["moves"])
        check("it says its language", b.run("document.documentElement.lang") == truth["language"], b.run("document.documentElement.lang"))
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
            take_pictures(b, arguments.lesson, pathlib.Path(arguments.pictures))
            b.window(1280, 800)
            b.open(arguments.lesson)
        if truth.get("slides"):
            check_slides(b, truth["slides"])
        if truth["eyes"]:
            check_picture(b)
        if truth["whole"]:
            check_drag(b, truth)
            check_hands(b, touch=False)
            check_keys(b, truth)
            check_quiz(b, truth)
            check_places(b, truth)
            check_short_names(b)
        if arguments.reference:
            check_reference(b, pathlib.Path(arguments.reference))
        check_layout(b, "1280 wide", slides=False)
        b.window(390, 844, 2, True)
        b.open(arguments.lesson)
        b.window(390, 844, 2, True)  # Firefox forgets how large it draws.
        time.sleep(0.5)
        if truth["whole"]:
            check_hands(b, touch=True)
            b.run("document.getElementById('ask').hidden || document.getElementById('ask').click()")
            check_layout(b, "390 wide, quiz", slides=False)
            b.run("document.getElementById('ask').hidden || document.getElementById('leave').click()")
        check_layout(b, "390 wide")
        check_names(b, truth)
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
