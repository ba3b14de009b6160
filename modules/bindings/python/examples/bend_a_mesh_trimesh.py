"""Bends a mesh of trimesh in place; its own checks and formats stay usable."""

from _example import kidney, needs, results

trimesh = needs("trimesh")
import viscera

points, triangles = kidney()
mesh = trimesh.Trimesh(points, triangles, process=False)
assert mesh.is_watertight

handles = viscera.place_handles(mesh.vertices, mesh.faces)
binding = viscera.bind(mesh.vertices, handles)
pose = handles.copy()
pose[handles[:, 2] > 30] += [12, 0, -6]
mesh.vertices = binding.pose(pose)
mesh.export(results() / "bent.stl")
print(f"volume by trimesh {mesh.volume / 1000:.3f} ml, by viscera "
      f"{viscera.volume(mesh.vertices, mesh.faces) / 1000:.3f} ml")
assert abs(mesh.volume / viscera.volume(mesh.vertices, mesh.faces) - 1) < 1e-9
