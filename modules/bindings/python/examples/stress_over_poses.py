"""How a kidney is distorted over 100 random poses: derivatives once, then a pass a pose."""

import csv

import numpy as np
from _example import kidney, results

import viscera

points, triangles = kidney()
handles = viscera.place_handles(points, triangles)
binding = viscera.bind(points, handles, softness=8)
inside, tetrahedra, witnesses = viscera.grid_witnesses(points, triangles, 1000)
stress = viscera.StressPoints(binding, inside)
random = np.random.default_rng(1)

rows = []
for number in range(100):
    size = 0.5 + 0.1 * number  # mm
    found = stress.evaluate(handles + random.normal(0, size, handles.shape)).statistics
    rows.append([number, size, np.degrees(found["mean"]), np.degrees(found["p95"]), found["folded"]])

with open(results() / "stress.csv", "w", newline="") as file:
    table = csv.writer(file)
    table.writerow(["pose", "noise_mm", "mean_deg", "p95_deg", "folded"])
    table.writerows(rows)
first, last = rows[0], rows[-1]
print(f"{witnesses} witness points; mean stress from {first[2]:.2f} to {last[2]:.2f} degrees")
assert last[2] > first[2] > 0
