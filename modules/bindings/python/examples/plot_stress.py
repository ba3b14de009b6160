"""A figure: stress by displacement of one handle, for three coordinate systems."""

from _example import kidney, needs, results

needs("matplotlib").use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import viscera

points, triangles = kidney(20, 28)
handles = viscera.place_handles(points, triangles)
way = np.linspace(0, 20, 21)
figure, axes = plt.subplots(figsize=(6, 4))
for name in ["s-celestial", "t-celestial", "mean-value"]:
    stress = viscera.StressPoints(viscera.bind(0.9 * points, handles, name))
    worst = []
    for distance in way:
        pose = handles.copy()
        pose[9] += [distance, 0, 0]
        worst.append(np.degrees(stress.evaluate(pose).statistics["p95"]))
    axes.plot(way, worst, label=viscera.system(name).name)
axes.set(xlabel="handle moved by (mm)", ylabel="rotational stress, 95 % (degrees)")
axes.legend()
file = results() / "stress.png"
figure.savefig(file, dpi=100)
print(f"wrote {file}")
assert file.stat().st_size > 5000
