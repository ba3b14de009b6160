"""What softness and locality do to one handle's reach and to the smoothness of a bend."""

import numpy as np
from _example import kidney

import viscera

points, triangles = kidney()
handles = viscera.place_handles(points, triangles)
pose = handles.copy()
pose[9] += [8, 0, 0]

print("softness  reach (vertices that feel handle 9 by 10 %)  largest stress")
for softness, binding in zip([0, 5, 10, 20], viscera.sweep(points, handles, "softness", [0, 5, 10, 20])):
    reach = int((binding.influence(9) > 0.1).sum())
    worst = viscera.rotational_stress(binding, pose).statistics["max"]
    print(f"{softness:5} mm  {reach:5}  {np.degrees(worst):6.1f} degrees")

reaches = []
for locality, binding in zip([0, 2, 4, 6], viscera.sweep(points, handles, "locality", [0, 2, 4, 6], softness=5)):
    reaches.append(float(np.sort(binding.weights, axis=1)[:, -4:].sum(axis=1).mean()))
    print(f"locality {locality}: the four nearest handles have {100 * reaches[-1]:.0f} % of all influence")
assert reaches == sorted(reaches)
