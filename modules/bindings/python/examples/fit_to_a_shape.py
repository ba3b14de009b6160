"""Finds the handles' places that bring an organ onto a target, by optimisation with exact gradients."""

from _example import kidney, needs

optimize = needs("scipy.optimize")
import numpy as np

import viscera

points, triangles = kidney(20, 28)
handles = viscera.place_handles(points, triangles)
binding = viscera.bind(points, handles, softness=5)
target = points * [1.1, 0.95, 1.0] + [3, 0, 0]
target[:, 0] += 0.003 * target[:, 2] ** 2


def distance(flat: np.ndarray) -> tuple[float, np.ndarray]:
    """The mean squared distance (mm^2) and its derivative with respect to every handle."""
    pose = flat.reshape(-1, 3)
    away = binding.pose(pose) - target
    return (away**2).sum() / len(points), binding.pull_back(pose, 2 * away / len(points)).ravel()


before = distance(handles.ravel())[0]
found = optimize.minimize(distance, handles.ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 300})
print(f"root mean square distance from {before**0.5:.2f} to {found.fun**0.5:.3f} mm in {found.nit} steps")
assert found.fun < 0.01 * before
