#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "array_memory.h"
#include "bound_points.h"
#include "long_jobs.h"
#include "parts.h"
#include "surface_from.h"
#include "viscera/core/error.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/sides_of_plane.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/surface_gap.h"
#include "viscera/geometry/volume.h"

namespace viscera::python {

namespace py = pybind11;

geometry::TriangleMesh meshFrom(const py::handle& points, const py::handle& triangles) {
  geometry::TriangleMesh mesh{*pointsFrom(points, "points"), *trianglesFrom(triangles, "triangles"), {}};
  geometry::requireValid(mesh, "the surface");
  return mesh;
}

void requireIndices(const Triangles& triangles, Eigen::Index points) {
  if (triangles.size() == 0 || (triangles.minCoeff() >= 0 && triangles.maxCoeff() < points))
    return;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (const std::int32_t index : triangles.row(t))
      if (index < 0 || index >= points)
        throw DataError("triangle " + std::to_string(t) + " names vertex " + std::to_string(index),
                        "triangles", "there are " + std::to_string(points) + " points");
}

namespace {

/// A pseudo-random number for the edge from `a` to `b`, and its negative for the edge from `b` to `a`.
std::uint64_t edgeNumber(std::int32_t a, std::int32_t b) {
  // Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014,
  // doi 10.1145/2660193.2660195.
  std::uint64_t z = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32U) |
                    static_cast<std::uint32_t>(std::max(a, b));
  z += 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return a < b ? z : 0 - z;
}

/// Whether every edge is run through as often in one direction as in the other, as in a closed surface of
/// consistent triangles. An open surface passes once in 2^64. O(m), without memory: volumes are asked for
/// frame by frame.
bool edgesCancel(const Triangles& triangles) {
  std::uint64_t sum = 0;
  for (const auto& triangle : triangles.rowwise())
    for (int k = 0; k < 3; ++k)
      if (triangle[k] != triangle[(k + 1) % 3])
        sum += edgeNumber(triangle[k], triangle[(k + 1) % 3]);
  return sum == 0;
}

/// Warns as Python does, so that a script can turn it off or into an error. Throws what the filter asks for.
void warnOfOpenSurface(const Points& points, const Triangles& triangles) {
  const geometry::SurfaceReport report = geometry::checkSurface({points, triangles, {}});
  const std::string text =
      report.closed() ? "the triangles do not all face the same way, so the surface has no certain volume"
                      : "the surface is open (" + std::to_string(report.boundaryEdges) +
                            " edges have one triangle), so it has no volume: the number depends on where the "
                            "surface lies";
  if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) < 0)
    throw py::error_already_set();
}

double volume(const py::object& points, const py::object& triangles, int threads) {
  const auto corners = pointsFrom(points, "points");
  const auto faces = trianglesFrom(triangles, "triangles");
  bool isClosed = true;
  const double found = unlocked([&] {
    requireIndices(*faces, corners->rows());
    isClosed = edgesCancel(*faces);
    return geometry::volume(*corners, *faces, {threads});
  });
  if (!isClosed)
    warnOfOpenSurface(*corners, *faces);
  return found;
}

double area(const py::object& points, const py::object& triangles) {
  const auto corners = pointsFrom(points, "points");
  const auto faces = trianglesFrom(triangles, "triangles");
  return unlocked([&] {
    requireIndices(*faces, corners->rows());
    return geometry::area(*corners, *faces);
  });
}

py::array pointGradient(const py::object& points, const py::object& triangles, int threads) {
  const auto corners = pointsFrom(points, "points");
  const auto faces = trianglesFrom(triangles, "triangles");
  Points gradient;
  unlocked([&] {
    requireIndices(*faces, corners->rows());
    geometry::volumeGradient(*corners, *faces, geometry::vertexTriangles(corners->rows(), *faces), gradient,
                             {threads});
  });
  return handOver(std::move(gradient));
}

py::array volumeGradient(const BoundPoints& bound, const py::object& triangles, const py::object& handles,
                         int threads) {
  const auto faces = trianglesFrom(triangles, "triangles");
  const auto pose = handles.is_none() ? std::make_shared<const Points>(bound.handles.positions)
                                      : pointsFrom(handles, "handles");
  requirePose(bound, *pose);
  Points atHandles;
  unlocked([&] {
    requireIndices(*faces, bound.binding->pointCount());
    Points points, atPoints;
    bound.binding->deform(*pose, points, {threads});
    geometry::volumeGradient(points, *faces, geometry::vertexTriangles(points.rows(), *faces), atPoints,
                             {threads});
    bound.binding->pullBack(*pose, atPoints, atHandles, {threads});
  });
  return handOver(std::move(atHandles));
}

geometry::SurfaceBoxes boxesOf(const py::object& points, const py::object& triangles) {
  geometry::TriangleMesh mesh = meshFrom(points, triangles);
  return {std::move(mesh.points), std::move(mesh.triangles)};
}

py::dict surfaceGap(const py::object& pointsA, const py::object& trianglesA, const py::object& pointsB,
                    const py::object& trianglesB) {
  const geometry::SurfaceBoxes first = boxesOf(pointsA, trianglesA), second = boxesOf(pointsB, trianglesB);
  const geometry::SurfaceGap gap = unlocked([&] { return geometry::gapBetween(first, second); });
  py::dict found;
  found["mm"] = gap.mm;
  found["from"] = handOver(Points(gap.from.transpose())).reshape(std::vector<py::ssize_t>{3});
  found["to"] = handOver(Points(gap.to.transpose())).reshape(std::vector<py::ssize_t>{3});
  return found;
}

py::dict sidesOfPlane(const py::object& points, const py::object& triangles, const py::object& origin,
                      const py::object& normal) {
  const auto corners = pointsFrom(points, "points");
  const auto faces = trianglesFrom(triangles, "triangles");
  const Vec3 direction = vectorFrom(normal, "normal");
  if (!(direction.norm() > 0))
    throw UsageError("it must not be zero", "normal");
  const geometry::Plane plane{vectorFrom(origin, "origin"), direction.normalized()};
  const geometry::SidesOfPlane sides = unlocked([&] {
    requireIndices(*faces, corners->rows());
    return geometry::sidesOfPlane({corners.get(), faces.get()}, plane);
  });
  py::dict found;
  found["front_mm3"] = sides.frontMm3;
  found["back_mm3"] = sides.backMm3;
  found["face_mm2"] = sides.faceMm2;
  return found;
}

py::dict check(const py::object& points, const py::object& triangles) {
  const geometry::TriangleMesh mesh = meshFrom(points, triangles);
  const geometry::SurfaceReport found = unlocked([&] { return geometry::checkSurface(mesh); });
  py::dict all;
  all["closed"] = found.closed();
  all["manifold"] = found.manifold();
  all["outward"] = found.outward();
  all["boundary_edges"] = found.boundaryEdges;
  all["non_manifold_edges"] = found.nonManifoldEdges;
  all["misoriented_edges"] = found.misorientedEdges;
  all["degenerate_triangles"] = found.degenerateTriangles;
  all["unused_vertices"] = found.unusedVertices;
  all["components"] = found.components;
  all["volume_mm3"] = found.volumeMm3;
  all["area_mm2"] = found.areaMm2;
  all["faults"] = inEnglish(geometry::faults(found));
  return all;
}

py::array normals(const py::object& points, const py::object& triangles) {
  const geometry::TriangleMesh mesh = meshFrom(points, triangles);
  return handOver(unlocked([&] { return geometry::vertexNormals(mesh); }));
}

py::array placeHandles(const py::object& points, const py::object& triangles, int count, bool enclosing,
                       double offset, double margin) {
  const geometry::TriangleMesh mesh = meshFrom(points, triangles);
  return handOver(unlocked([&] {
    return deformation::placeHandles(mesh, {count, enclosing, offset, margin});
  }));
}

py::tuple groupsAlongAxis(const py::object& handles, const py::object& points, int count, double overlap) {
  const auto rig = pointsFrom(handles, "handles");
  const auto organ = pointsFrom(points, "points");
  const auto found = unlocked([&] { return deformation::groupsAlongAxis(*rig, *organ, count, overlap); });
  Points all(rig->rows() + found.added.rows(), 3);
  all << *rig, found.added;
  py::dict groups;
  for (const auto& group : found.groups)
    groups[py::str(group.name)] = group.handles;
  return py::make_tuple(handOver(std::move(all)), groups);
}

py::tuple tupleOf(deformation::WitnessMesh mesh) {
  const Eigen::Index witnesses = mesh.witnesses;
  return py::make_tuple(handOver(std::move(mesh.points)), handOver(std::move(mesh.tetrahedra)), witnesses);
}

py::tuple tetrahedralise(const py::object& points, const py::object& triangles, double maxVolume,
                         double timeLimit, const py::object& listener) {
  const geometry::TriangleMesh mesh = meshFrom(points, triangles);
  deformation::TetrahedraOptions options;
  options.maxVolumeMm3 = maxVolume;
  options.timeLimitSeconds = timeLimit;
  return tupleOf(resultOfLong(
      listener, [&](Progress& progress) { return deformation::tetrahedralise(mesh, options, progress); }));
}

py::tuple gridWitnesses(const py::object& points, const py::object& triangles, int count,
                        const py::object& listener) {
  const geometry::TriangleMesh mesh = meshFrom(points, triangles);
  return tupleOf(resultOfLong(
      listener, [&](Progress& progress) { return deformation::gridWitnesses(mesh, count, progress); }));
}

} // namespace

void addSurfaces(py::module_& module) {
  const auto points = py::arg("points");
  const auto triangles = py::arg("triangles");
  module.def("volume", &volume, points, triangles, py::arg("threads") = 0,
             "The signed volume (mm^3) inside a closed surface: points n x 3 mm, triangles m x 3. Warns "
             "(UserWarning) "
             "of a surface that is open, or whose triangles face different ways. O(m).");
  module.def("area", &area, points, triangles,
             "The area (mm^2) of a surface: points n x 3 mm, triangles m x 3. O(m).");
  module.def("point_volume_gradient", &pointGradient, points, triangles, py::arg("threads") = 0,
             "The derivative of the volume with respect to every point: n x 3, mm^2. O(m).");
  module.def("volume_gradient", &volumeGradient, py::arg("binding"), triangles,
             py::arg("handles") = py::none(), py::arg("threads") = 0,
             "The derivative of the volume with respect to every handle: h x 3, mm^2, at the pose `handles` "
             "(h x 3 mm; none: at rest). O(n h + m).");
  module.def(
      "surface_gap", &surfaceGap, py::arg("points_a"), py::arg("triangles_a"), py::arg("points_b"),
      py::arg("triangles_b"),
      "The shortest way between two surfaces (points n x 3 mm, triangles m x 3): mm (0 where they touch or "
      "cross), and its ends `from` on the first and `to` on the second, 3 mm. Exact but for rounding. "
      "O(m log m).");
  module.def(
      "sides_of_plane", &sidesOfPlane, points, triangles, py::arg("origin"), py::arg("normal"),
      "What a plane makes of a closed surface (points n x 3 mm, triangles m x 3): front_mm3 on the side "
      "that `normal` (3, of any length) points to, back_mm3, and face_mm2, the area of the cut. Exact but "
      "for rounding. O(m).");
  module.def("check_surface", &check, points, triangles,
             "What a surface (points n x 3 mm, triangles m x 3) is worth as an organ: closed, manifold, "
             "outward, boundary_edges, "
             "non_manifold_edges, misoriented_edges, degenerate_triangles, unused_vertices, components, "
             "volume_mm3, area_mm2, faults (sentences). O(m log m).");
  module.def("vertex_normals", &normals, points, triangles, "Unit normals of the vertices: n x 3, float32.");
  module.def(
      "place_handles", &placeHandles, points, triangles, py::arg("count") = 30, py::arg("enclosing") = true,
      py::arg("offset") = 0.03, py::arg("margin") = 0.15,
      "`count` handles (count x 3, mm) just off a surface (points n x 3 mm, triangles m x 3), spread evenly; "
      "with `enclosing` the corners of a "
      "box around it come first, so that every vertex can be bound. `offset` and `margin` (of the box) are "
      "parts of the surface's diagonal. Deterministic.");
  module.def(
      "enclosing_handles",
      [](const py::object& array, double margin) {
        return handOver(deformation::enclosingHandles(*pointsFrom(array, "points"), margin));
      },
      points, py::arg("margin") = 0.15, "The 8 corners (8 x 3, mm) of a box around points (n x 3, mm).");
  module.def(
      "groups_along_axis", &groupsAlongAxis, py::arg("handles"), points, py::arg("count"),
      py::arg("overlap") = 0.25,
      "Groups for localised coordinates: `count` parts along the longest axis of the points. The handles "
      "(h x 3, mm), with those that had to be added, and a dict of name and rows.");
  module.def(
      "tetrahedralise", &tetrahedralise, points, triangles, py::arg("max_volume") = 0.0,
      py::arg("time_limit") = 60.0, py::arg("progress") = py::none(),
      "Fills a closed surface with tetrahedra of at most `max_volume` (mm^3; 0: any) by TetGen, in a "
      "process of its own that is ended after `time_limit` (s): points (n x 3, mm), tetrahedra (t x 4) "
      "and the number of points, the first ones, that lie inside.");
  module.def(
      "grid_witnesses", &gridWitnesses, points, triangles, py::arg("count"), py::arg("progress") = py::none(),
      "About `count` points on a regular grid inside a surface (points n x 3 mm, triangles m x 3) of any "
      "state, likewise: points p x 3 mm, tetrahedra t x 4, and how many points lie inside. Raises "
      "DataError, Cancelled.");
}

} // namespace viscera::python
