#pragma once

#include <array>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {

/// A triangle surface. An organ's surface is closed and its triangles are counter-clockwise seen from
/// outside.
///
///     TriangleMesh mesh;
///     mesh.points.resize(4, 3);
///     mesh.points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
///     mesh.triangles.resize(4, 3);
///     mesh.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
///     requireValid(mesh, "corner");
struct TriangleMesh {
  Points points;       ///< `n x 3`, mm, LPS.
  Triangles triangles; ///< `m x 3` indices into `points`.
  Colors colors;       ///< `n x 3`, one colour a vertex, or empty.
};

/// The corners of triangle `t`, mm.
inline std::array<Vec3, 3> cornersOf(const Points& points, const Triangles& triangles, Eigen::Index t) {
  return {points.row(triangles(t, 0)).transpose(), points.row(triangles(t, 1)).transpose(),
          points.row(triangles(t, 2)).transpose()};
}

/// The triangles around every vertex, as a compressed list: those of vertex v are
/// `items[first[v]] ... items[first[v + 1] - 1]`, ascending.
struct VertexTriangles {
  std::vector<std::int32_t> first; ///< `n + 1` offsets.
  std::vector<std::int32_t> items; ///< `3 m` triangle numbers.
};

/// The triangles around each of `vertexCount` vertices. O(n + m).
VertexTriangles vertexTriangles(Eigen::Index vertexCount, const Triangles& triangles);

/// Throws `DataError` that names the first offending element when a coordinate is not finite or a triangle's
/// index is out of range. `where` names the mesh in the message. O(n + m).
void requireValid(const TriangleMesh& mesh, const Text& where);

/// Scales a surface about the origin, to convert coordinates from another unit. Colours stay. O(n + m).
///
/// Every coordinate times `factor` (positive).
TriangleMesh scaled(TriangleMesh mesh, double factor);

/// Rotates a surface by half a turn about the axis from foot to head, which converts RAS to LPS and back: x
/// and y change their signs, nothing is mirrored. Twice is the same bits again.
TriangleMesh turnedHalf(TriangleMesh mesh);

/// Left and right exchanged: x changes its sign, and every triangle is turned around so that what faced
/// outward still does. Twice is the same bits again.
TriangleMesh mirrored(TriangleMesh mesh);

} // namespace viscera::geometry
