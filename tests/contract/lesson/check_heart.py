#!/usr/bin/python3
"""Opens a lesson whose heart can be cut open, and checks its buttons, names, quiz and layout (docs/lessons.md).

Usage: check_heart.py LESSON.html [--browser firefox]. Exit status 0: all checks passed."""
import argparse, json, sys, time

from check_page import ASKABLE, NAMES, OVERLAPS, PLACES, check, failed
from chromium import Chromium
from firefox import Firefox

PIXELS = """(() => { viscera.render(); const g = viscera.gl, w = g.canvas.width, h = g.canvas.height, p = new Uint8Array(4 * w * h);
  g.readPixels(0, 0, w, h, g.RGBA, g.UNSIGNED_BYTE, p); return p.reduce((sum, v, i) => (sum + v * (1 + i % 9973)) % 1e12, 0); })()"""
PRESSED = "document.getElementById('%s').getAttribute('aria-pressed') === 'true'"
AWAY = "viscera.nameItems.filter(i => i.shown && viscera.isCutAway(viscera.placeOf(i.seen))).map(i => i.text)"


def click(b, button):
    b.run(f"document.getElementById('{button}').click(), viscera.render()")


def check_cut(b):
    check("a heart is whole at first", b.run("!viscera.opened() && document.getElementById('blood').hidden"))
    whole = b.run(PIXELS)
    click(b, "cut")
    empty = b.run(PIXELS)
    check("it is cut open", b.run("viscera.opened() && " + PRESSED % "cut") and empty != whole)
    click(b, "blood")
    check("blood fills it", b.run(PRESSED % "blood") and b.run(PIXELS) != empty)
    click(b, "blood")
    check("and leaves it", b.run(PIXELS) == empty)
    for fraction in (0.1, 0.5):
        b.run(f"viscera.showNames(true), viscera.seek({fraction}), viscera.render()")
        time.sleep(0.35)  # What is seen is looked for three times a second.
        found = b.run(PLACES)
        check(f"names in an open heart are at their own seen parts, at {fraction}", not found["hidden"] and not found["foreign"] and not b.run(AWAY), found)
    check("chambers have their names", b.run("viscera.nameItems.filter(i => i.shown && !i.part).length") >= 3)


def check_conduction(b):
    light = "Math.max(...viscera.cordColors.filter((_, i) => i % 4 === 2))"
    b.run("viscera.seek(0.3), viscera.render()")
    dark = b.run(PIXELS)
    click(b, "conduct")
    check("the conduction system is shown", b.run(PRESSED % "conduct") and b.run(PIXELS) != dark)
    begins = b.run("viscera.conduction.beats[viscera.state.rate].begins")
    b.run(f"viscera.seek({begins} - 0.03), viscera.render()")
    rest = b.run(light)
    b.run(f"viscera.seek({begins} + 0.02), viscera.render()")
    check("it lights up when the sinus node fires", b.run(light) > rest + 40, (rest, b.run(light)))
    b.key("e")
    check("a key hides it", not b.run(PRESSED % "conduct"))


def check_quiz(b):
    b.run("document.getElementById('ask').click(), viscera.render()")
    found = b.run(ASKABLE)
    check("parts of an open heart are asked at their places", found["names"] and not found["wrong"], found)
    check("and only where they are seen", not b.run("viscera.askable().filter(a => viscera.isHidden(a.item.s, a.vertex, a.item.ring) || viscera.isCutAway(viscera.placeOf(a.vertex))).map(a => a.item.text)"))
    own = b.run("(q => !q.item || [...document.getElementById('choices').children].some(c => c.textContent === q.item.text))(viscera.quiz)")
    check("the marked part's name is among the choices", own)
    b.run("document.getElementById('leave').click(), viscera.render()")
    check("the heart stays open after the quiz", b.run("viscera.opened()"))


def main(arguments):
    b = Firefox() if arguments.browser == "firefox" else Chromium()
    try:
        b.window(1280, 800)
        b.prefer()
        b.open(arguments.lesson)
        check_cut(b)
        check_conduction(b)
        check_quiz(b)
        b.key("c")
        check("a key closes it", b.run("!viscera.opened()"))
        b.window(390, 844, 2, True)
        b.open(arguments.lesson)
        b.window(390, 844, 2, True)  # Firefox forgets how large it draws.
        b.run("viscera.setCut(true), viscera.setConduction(true), viscera.showNames(true), viscera.render()")
        time.sleep(0.35)
        found = b.run(OVERLAPS)
        check("nothing overlaps on a phone", not found, found)
        found = b.run(NAMES)
        check("names on a phone overlap nothing", found["shown"] and not found["overlaps"] and not found["outside"], found)
        check("nothing is said on the console", not b.said(), json.dumps(b.said()))
        check("everything to grip has a name", not b.nameless(), b.nameless())
    finally:
        b.end()
    print(f"{len(failed)} failed: {failed}" if failed else "all passed")
    return 1 if failed else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lesson")
    parser.add_argument("--browser", choices=("chromium", "firefox"), default="chromium")
    sys.exit(main(parser.parse_args()))
