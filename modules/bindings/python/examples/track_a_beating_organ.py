"""A patient's own motion: eight surfaces over a cycle become one rig and its poses, with every volume kept."""

import numpy as np
from _example import kidney, results

import viscera

# A cavity that empties by half, a surface a phase, as a segmentation of a cine scan gives them.
points, triangles = kidney(16, 20)
folder = results() / "phases"
folder.mkdir(exist_ok=True)
volumes = []
try:
    for phase in range(8):
        squeeze = 0.5 - 0.5 * np.cos(2 * np.pi * phase / 8)
        moved = points * [1 - 0.3 * squeeze, 1 - 0.25 * squeeze, 1 - 0.05 * squeeze]
        viscera.write_surface(folder / f"cavity_{phase}.ply", moved, triangles)
        volumes.append(viscera.volume(moved, triangles) / 1000)
    motion = viscera.track(folder, period=0.9, handles=40)
except viscera.MissingPart as missing:
    print("skipped:", missing)
    raise SystemExit(77)

motion.write(results() / "cavity.sequence.json")  # `viscera play` and the window play it
for phase in motion.phases:
    print(f"{1000 * phase['seconds']:4.0f} ms: {phase['mean_mm']:.2f} mm away, {phase['fit']}")
found = motion.indices["cavity"]
print(f"{found['end_diastolic_volume_ml']:.1f} to {found['end_systolic_volume_ml']:.1f} ml: ejection fraction {found['ejection_fraction']:.2f}")
assert abs(found["ejection_fraction"] - (1 - min(volumes) / max(volumes))) < 1e-4

beat = motion.sequence
rest, faces = beat.surfaces["cavity"]
bound = viscera.bind(rest, beat.rest_handles, beat.system, **beat.parameters)
between = viscera.volume(bound.pose(beat.pose(0.05)), faces) / 1000
print(f"50 ms into the beat: {between:.1f} ml")
assert min(volumes) < between < max(volumes) * 1.01
