#!/usr/bin/env python3
"""How much nearer to elasticity a pose comes when its free handles follow (docs/elasticity.md).

    resources/scripts/measure_least_energy.py build/release/bin/viscera [--organs NAME...] [--drags N]

Each of N handles of an organ (a sample's name, or a surface file) is dragged by 5 % of the diagonal of the handles near it, away from the organ's middle, while the 10
farthest handles hold it; all others are free, in the elastic organ too. Patches move as their handles, or as the posed surface does there. Prints
a Markdown table.
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

ORGANS = ["liver", "stomach", "kidney_left", "kidney_right"]
ENCLOSING = 8  # The first handles are the corners of a box around the organ.
DRAG = 0.05
HELD = 10


def read(viscera, *arguments):
    done = subprocess.run([viscera, *arguments, "--json"], capture_output=True, text=True)
    return json.loads(done.stdout) if done.returncode == 0 else None


def source(organ):
    return organ if pathlib.Path(organ).suffix else f"sample:{organ}"


def control_points(markup):
    return [point for one in markup["markups"] for point in one["controlPoints"]]


def drags(points, count):
    """Handles that are evenly spread over those near the organ."""
    near = list(range(ENCLOSING, len(points)))
    return [near[(2 * i + 1) * len(near) // (2 * count)] for i in range(count)]


def measure(viscera, organ, count, folder):
    rest = folder / "rest.mrk.json"
    subprocess.run([viscera, "handles", source(organ), "-o", str(rest), "--force"], check=True, capture_output=True)
    markup = json.loads(rest.read_text())
    points = control_points(markup)
    places = [p["position"] for p in points]
    near = places[ENCLOSING:]
    low, high = [[f(p[a] for p in near) for a in range(3)] for f in (min, max)]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    rows = []
    for handle in drags(points, count):
        away = [a - b for a, b in zip(places[handle], middle)]
        factor = DRAG * math.dist(low, high) / math.hypot(*away)
        moved = json.loads(rest.read_text())
        control_points(moved)[handle]["position"] = [a + factor * b for a, b in zip(places[handle], away)]
        pose = folder / "pose.mrk.json"
        pose.write_text(json.dumps(moved))
        farthest = sorted(range(len(points)), key=lambda other: -math.dist(places[other], places[handle]))
        options = [option for other in farthest[:HELD] for option in ("--hold", points[other]["label"])]
        for grips in ("handle", "surface"):
            found = read(viscera, "elasticity", source(organ), "--handles", str(rest), "--pose", str(pose),
                         "--free-handles-follow", "--grips", grips, *options)
            rows.append((organ, points[handle]["label"], grips, found))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("viscera")
    parser.add_argument("--organs", nargs="+", default=ORGANS)
    parser.add_argument("--drags", type=int, default=3)
    chosen = parser.parse_args()
    print("| organ | drag of | patches move as | handles that follow | at rest: median, 95 % | following: median, 95 % | energy |")
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for organ in chosen.organs:
            for name, label, grips, found in measure(chosen.viscera, organ, chosen.drags, pathlib.Path(folder)):
                if not found:
                    print(f"| {name} | {label} | {grips} | | no equilibrium | | |", flush=True)
                    continue
                at_rest, follow = found["differencePercentOfDrag"], found["leastEnergy"]
                there = follow["differencePercentOfDrag"]
                print(f"| {name} | {label} | {grips} | {follow['followingHandles']} "
                      f"| {at_rest['median']:.1f}, {at_rest['p95']:.1f} % | {there['median']:.1f}, {there['p95']:.1f} % "
                      f"| {100 * follow['energyRatio']:.0f} % |", flush=True)


if __name__ == "__main__":
    main()
