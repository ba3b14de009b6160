#!/usr/bin/env python3
"""How much the elastic displacement depends on the size of the tetrahedra (docs/elasticity.md).

    resources/scripts/measure_mesh_convergence.py build/release/bin/viscera [--organs NAME...] [--meshes N...] [--drag PART]

One handle of an organ (a sample's name, or a surface file) is dragged by a part of the diagonal of the handles near it, away from the organ's middle;
all others hold it. Prints a Markdown table.
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

from measure_least_energy import ENCLOSING, control_points, drags, read, source

ORGANS = ["liver", "kidney_left"]
MESHES = ["300", "600", "1200", "2400", "4800"]


def posed(viscera, organ, part, folder):
    """Files of the handles at rest and in a pose with one of them dragged."""
    rest, pose = folder / "rest.mrk.json", folder / "pose.mrk.json"
    subprocess.run([viscera, "handles", source(organ), "-o", str(rest), "--force"], check=True, capture_output=True)
    moved = json.loads(rest.read_text())
    points = control_points(moved)
    near = [p["position"] for p in points[ENCLOSING:]]
    low, high = [[f(p[a] for p in near) for a in range(3)] for f in (min, max)]
    dragged = points[drags(points, 1)[0]]
    away = [p - (a + b) / 2 for p, a, b in zip(dragged["position"], low, high)]
    factor = part * math.dist(low, high) / math.hypot(*away)
    dragged["position"] = [p + factor * a for p, a in zip(dragged["position"], away)]
    pose.write_text(json.dumps(moved))
    return str(rest), str(pose)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("viscera")
    parser.add_argument("--organs", nargs="+", default=ORGANS)
    parser.add_argument("--meshes", nargs="+", default=MESHES)
    parser.add_argument("--drag", type=float, default=0.02)
    chosen = parser.parse_args()
    print("| organ | tetrahedra | edge | from the finest: median, 95 %, largest | from the pose: median, 95 % | smallest J | order |")
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for organ in chosen.organs:
            rest, pose = posed(chosen.viscera, organ, chosen.drag, pathlib.Path(folder))
            found = read(chosen.viscera, "elasticity", source(organ), "--handles", rest, "--pose", pose,
                         "--meshes", *chosen.meshes)
            if not found:
                print(f"| {organ} | no equilibrium | | | | | |", flush=True)
                continue
            for mesh in found["meshes"]:
                finest, apart = mesh["fromFinestPercentOfDrag"], mesh["differencePercentOfDrag"]
                last = mesh is found["meshes"][-1]
                between = "" if last else f"{finest['median']:.2f}, {finest['p95']:.1f}, {finest['max']:.0f} %"
                order = f"{found['order']:.1f}" if last and found["order"] is not None else ""
                print(f"| {organ} | {mesh['tetrahedra']} | {mesh['edgeMm']:.1f} mm | {between} "
                      f"| {apart['median']:.1f}, {apart['p95']:.1f} % | {mesh['volumeRatioMin']:.2f} | {order} |", flush=True)


if __name__ == "__main__":
    main()
