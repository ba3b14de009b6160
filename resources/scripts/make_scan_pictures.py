#!/usr/bin/env python3
"""Draws the window with a patient's CT, organs and a deformed liver into docs/pictures, dark and light.

make_scan_pictures.py CT LABELS [PROGRAM]: a scan, its label map with the organs below, and the program
(build/release/bin/viscera unless another one is named). Needs a display, which a virtual one can be:

    xvfb-run resources/scripts/make_scan_pictures.py ct.nii.gz segmentation.nii.gz
"""

import base64
import hashlib
import json
import math
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
COLORS = {
    "liver": (0.72, 0.36, 0.30), "spleen": (0.62, 0.42, 0.62), "kidney_left": (0.75, 0.55, 0.35),
    "kidney_right": (0.75, 0.55, 0.35), "gallbladder": (0.45, 0.70, 0.40), "stomach": (0.85, 0.62, 0.55),
    "pancreas": (0.90, 0.75, 0.40), "colon": (0.80, 0.65, 0.45), "vertebrae_T12": (0.88, 0.84, 0.72),
    "vertebrae_L1": (0.88, 0.84, 0.72), "vertebrae_L2": (0.88, 0.84, 0.72), "aorta": (0.85, 0.25, 0.25),
    "inferior_vena_cava": (0.35, 0.45, 0.85)}  # fmt: skip
TRIANGLES = 6000
PUSH_MM = (-6, 34, 4)  # What presses the liver in from the front.
REACH_MM = 95
BOX_GROWTH = 1.25


def off_surface(file):
    """Points and triangles of an OFF file, which may have colours."""
    rows = [line.split("#")[0].split() for line in file.read_text().splitlines()]
    rows = [row for row in rows if row][1:]
    count = int(rows[0][0])
    points = [tuple(map(float, row[:3])) for row in rows[1 : 1 + count]]
    return points, [tuple(map(int, row[1:4])) for row in rows[1 + count :]]


def organ(number, name, surface):
    points, triangles = surface
    p = b"".join(struct.pack("<3d", *point) for point in points)
    t = b"".join(struct.pack("<3i", *triangle) for triangle in triangles)
    packed = [base64.b64encode(zlib.compress(data)).decode() for data in (p, t)]
    return {
        "id": number, "name": (name[0].upper() + name[1:]).replace("_", " "),
        "look": {"color": COLORS[name], "vertexColors": True, "opacity": 1, "visible": True, "tracked": name == "liver"},
        "volumeLocked": False, "sha256": hashlib.sha256(p + t).hexdigest(),
        "surface": {"vertices": len(points), "triangles": len(triangles), "points": packed[0], "indices": packed[1]}, "warnings": []}  # fmt: skip


def box_of(points, growth=1.0):
    low, high = [min(p[k] for p in points) for k in range(3)], [max(p[k] for p in points) for k in range(3)]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    return [(m - growth * (m - a), m + growth * (b - m)) for m, a, b in zip(middle, low, high)]


def handles_of(markups, liver, everything):
    """Handles on the liver, and the corners of a box around all organs, so that nothing lies outside."""
    rest = [
        (point["position"], True)
        for item in json.loads(markups.read_text())["markups"]
        for point in item["controlPoints"]
    ]
    box = box_of(everything, BOX_GROWTH)
    rest += [([box[k][corner >> k & 1] for k in range(3)], False) for corner in range(8)]
    sides = box_of(liver)
    front = [sum(sides[0]) / 2 - 15, sides[1][0], sum(sides[2]) / 2]  # LPS: the least y is in front.
    handles = []
    for number, (place, on_liver) in enumerate(rest):
        handle = {"id": 100 + number, "label": f"H-{number + 1}", "rest": place, "locked": False, "visible": on_liver,
                  "compensates": False}  # fmt: skip
        part = max(0, 1 - math.dist(place, front) / REACH_MM) ** 0.7 if on_liver else 0
        if part > 0:
            handle["pose"] = [a + part * b for a, b in zip(place, PUSH_MM)]
        handles.append(handle)
    return handles, front


def measurements(z):
    """A kidney's width, and the values in the liver and in the spleen, on the axial slice at z mm."""

    def points(*places):
        return [{"rest": [x, y, z]} for x, y in places]

    return [
        {"id": 1001, "name": "Kidney", "points": points((-77, -120), (-33, -120))},
        {"id": 1002, "name": "Liver", "kind": "sphere", "points": points((-112, -167), (-94, -167))},
        {"id": 1003, "name": "Spleen", "kind": "rectangle", "slice": "axial", "points": points((119, -145), (135, -118))},
    ]  # fmt: skip


def session(scan, organs, handles, front, mode):
    deform = mode == "deform"
    measured = {} if deform else {"measurements": measurements(front[2])}
    return measured | {
        "format": "viscera-session", "version": 2, "coordinateSystem": "LPS", "units": "mm", "surfaces": "embedded",
        "organs": organs, "rig": {"handles": handles, "groups": []},
        "system": {"id": "s-celestial", "parameters": {}},
        "recording": {"name": "Recorded", "periodSeconds": 2, "loop": True, "interpolation": "eased", "keys": []},
        "scan": {"name": "CT of the abdomen", "relative": scan.name, "absolute": str(scan)},
        "view": {"format": 2, "mode": mode,
                 "shown": {"rest": False, "handles": deform, "movable": deform, "compensating": False, "tools": deform,
                           "regions": False, "stress": False},
                 "measurements": True, "orientationCube": True, "scaleBar": True,
                 "selection": {"organ": 1, "group": 0, "handles": []},
                 "scan": {"layout": "four", "focus": [front[0] + 5, front[1] + 55, front[2]], "level": 60, "width": 350,
                          "slabMm": 0, "maximum": False, "smooth": True, "contours": True, "rest": True,
                          "standing": False, "bent": deform}}}  # fmt: skip


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    scan, labels = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    program = sys.argv[3] if len(sys.argv) > 3 else str(SOURCE / "build/release/bin/viscera")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        subprocess.run([program, "segment", labels, "-o", work, "--labels", ",".join(COLORS), "--largest-piece",
                        "--triangles", str(TRIANGLES), "--format", "off"], check=True, stdout=subprocess.DEVNULL)  # fmt: skip
        subprocess.run([program, "handles", work / "liver.off", "-o", work / "liver.mrk.json", "--count", "30"],
                       check=True, stdout=subprocess.DEVNULL)  # fmt: skip
        surfaces = {name: off_surface(work / f"{name}.off") for name in COLORS}
        organs = [organ(number, name, surface) for number, (name, surface) in enumerate(surfaces.items(), 1)]
        everything = [point for points, _ in surfaces.values() for point in points]
        handles, front = handles_of(work / "liver.mrk.json", surfaces["liver"][0], everything)
        patient = work / "patient"  # Alone: the label map beside it would be offered.
        patient.mkdir()
        shutil.copy(scan, patient)
        for theme, mode, name in (("dark", "deform", "window_scan"), ("light", "explore", "window_scan_light")):
            file = work / f"{name}.viscera"
            file.write_text(json.dumps(session(patient / scan.name, organs, handles, front, mode)))
            subprocess.run([program, file, "--fresh-settings", "--theme", theme, "--window-size", "1600x1000",
                            "--screenshot", SOURCE / "docs/pictures" / f"{name}.png"], check=True)  # fmt: skip


if __name__ == "__main__":
    main()
