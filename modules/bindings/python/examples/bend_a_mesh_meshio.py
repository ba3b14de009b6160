"""Bends a mesh of any format that meshio reads, and writes it again."""

from _example import kidney, needs, results

meshio = needs("meshio")
import numpy as np

import viscera

folder = results()
points, triangles = kidney()
meshio.write(folder / "kidney.ply", meshio.Mesh(points, [("triangle", triangles)]))

mesh = meshio.read(folder / "kidney.ply")
triangles = mesh.cells_dict["triangle"]
handles = viscera.place_handles(mesh.points, triangles)
binding = viscera.bind(mesh.points, handles)

pose = handles.copy()
top = handles[:, 2] > 30
pose[top] += [12, 0, -6]  # the upper pole, mm
bent = binding.pose(pose)
meshio.write(folder / "bent.vtk", meshio.Mesh(bent, mesh.cells, point_data={"moved_mm": bent - mesh.points}))

moved = np.linalg.norm(bent - mesh.points, axis=1)
print(f"{top.sum()} handles moved; points by {moved.max():.1f} mm at most")
print(f"volume {viscera.volume(mesh.points, triangles) / 1000:.2f} ml, bent "
      f"{viscera.volume(bent, triangles) / 1000:.2f} ml")
assert moved.max() > 5
