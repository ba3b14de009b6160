#!/usr/bin/env python3
"""draw_heart_cuts.py PROGRAM FOLDER [--theme light|dark] [--size WxH] [--labels]

Draws the sample heart in the nine cuts of an atlas, each as heart_cut_NAME.png in FOLDER, and from its six sides, as heart_views.png.
Each cut is a session of its own, which `PROGRAM render` draws; no display is needed. Planes go through the landmarks of
sample_organs/heart.json: valves, apex, vessels. A plane keeps what lies along its normal, and the camera looks along it.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

SURFACES = {"outer": "Heart", "lv": "LV", "rv": "RV", "la": "LA", "ra": "RA"}
SIDES = ["anterior", "posterior", "left", "right", "superior", "inferior"]
ORIGIN, TO_SEPTUM, TO_APEX = (-8, 22, 18), (-0.62, -0.78, 0.05), (0.64, -0.55, -0.54)
SEEN = (-5, 8, 34)  # The middle of the pictures, mm.
DISTANCE, ANGLE = 480, 24  # Of the camera, mm, and its angle of view.


def plus(a, b, factor=1):
    return tuple(x + factor * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / dot(a, a) ** 0.5 for x in a)


# Orthonormal, as the program makes it of the definition's axes: the one to the apex is kept.
C = unit(TO_APEX)
A = unit(plus(TO_SEPTUM, C, -dot(TO_SEPTUM, C)))
B = cross(C, A)


def at(a, b, c):
    """A place in the left ventricle's frame: towards the septum, the diaphragm and the apex."""
    return plus(plus(plus(ORIGIN, A, a), B, b), C, c)


MITRAL, AORTIC, TRICUSPID, PULMONARY = at(-5.2, 7, 1), at(7.5, -10, -4), at(40.6, 14.2, 3.5), at(28, -37, 18)
APEX, RIGHT_APEX, ASCENDING, SUPERIOR_CAVA = at(0, 0, 88), at(40, -2, 62), (-22, 4, 58), (-48, 16, 76)


def through(first, second, third, stays):
    """The plane through three places; what lies towards `stays` remains."""
    normal = unit(cross(plus(second, first, -1), plus(third, first, -1)))
    return first, normal if dot(normal, stays) > 0 else tuple(-x for x in normal)


# Name: a point of the plane, the direction that remains.
CUTS = {
    "four_chamber": through(MITRAL, TRICUSPID, APEX, B),
    "two_chamber": through(MITRAL, plus(MITRAL, B, 20), APEX, A),
    "three_chamber": through(MITRAL, AORTIC, APEX, A),
    "short_axis_base": (at(0, 0, 10), tuple(-x for x in C)),
    "short_axis_papillary": (at(0, 0, 44), tuple(-x for x in C)),
    "short_axis_apex": (at(0, 0, 70), tuple(-x for x in C)),
    "outflow_tracts": through(AORTIC, ASCENDING, PULMONARY, (0, 1, 0)),
    "sagittal_cavae": (SUPERIOR_CAVA, (-1, 0, 0)),
    "right_outflow": through(TRICUSPID, PULMONARY, RIGHT_APEX, A),
}


def bounds(program):
    """Middle and radius of the ball around the heart, from which a session counts its plane."""
    said = subprocess.run([program, "info", "sample:heart", "--json"], check=True, stdout=subprocess.PIPE, text=True).stdout
    box = json.loads(said)["boundsMm"]
    low, high = box[0::2], box[1::2]
    size = plus(high, low, -1)
    return tuple((a + b) / 2 for a, b in zip(low, high)), dot(size, size) ** 0.5 / 2


def session(point, normal, middle, radius, labels):
    """The heart at rest, cut by the plane and seen along its normal, upright where that is possible."""
    look = {"color": [0.7, 0.3, 0.3], "vertexColors": True, "opacity": 1, "visible": True, "tracked": True}
    # A hash that fits no surface: each is made of today's definition, and the program says so.
    organs = [{"id": i + 1, "name": name, **({"parent": 1} if i else {}), "look": look, "volumeLocked": False,
               "source": {"sample": "heart@medium", "surface": surface}, "sha256": "0" * 64}
              for i, (surface, name) in enumerate(SURFACES.items())]
    height = dot(plus(point, middle, -1), normal)
    focus = plus(SEEN, normal, dot(plus(point, SEEN, -1), normal))
    up = (0, 0, 1) if abs(normal[2]) < 0.9 else (0, -1, 0)
    camera = {"position": plus(focus, normal, -DISTANCE), "focus": focus, "up": unit(plus(up, normal, -dot(up, normal))),
              "angleDegrees": ANGLE}
    cut = {"on": True, "normal": normal, "offset": height / radius, "blood": False}
    return {"format": "viscera-session", "version": 2, "coordinateSystem": "LPS", "units": "mm", "surfaces": "linked",
            "organs": organs, "rig": {"handles": [], "groups": []}, "system": {"id": "s-celestial", "parameters": {}},
            "recording": {"name": "", "periodSeconds": 1, "loop": True, "interpolation": "eased", "keys": []},
            "view": {"format": 3, "camera": camera, "cut": cut, "partNames": labels, "labels": labels, "measurements": False,
                     "scaleBar": True, "orientationCube": False}}


def draw(program, what, picture, options):
    done = subprocess.run([program, "render", str(what), "-o", str(picture), *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True)
    if done.returncode != 0:
        raise SystemExit(done.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--theme", choices=["light", "dark"], default="light")
    parser.add_argument("--size", default="300x300")
    parser.add_argument("--labels", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    look = ["--size", options.size, "--theme", options.theme]
    middle, radius = bounds(options.program)
    with tempfile.TemporaryDirectory() as work:
        for name, (point, normal) in CUTS.items():
            file = pathlib.Path(work) / f"{name}.viscera"
            file.write_text(json.dumps(session(point, normal, middle, radius, options.labels)), encoding="utf-8")
            draw(options.program, file, options.folder / f"heart_cut_{name}.png", look)
    draw(options.program, "sample:heart", options.folder / "heart_views.png", ["--views", ",".join(SIDES), *look])


if __name__ == "__main__":
    main()
