#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A triangle surface. An organ's surface is closed and its triangles are counter-clockwise seen from
/// outside.
struct TriangleMesh {
  Points points;       ///< `n x 3`, mm, LPS.
  Triangles triangles; ///< `m x 3` indices into `points`.
  Colors colors;       ///< `n x 3`, one colour a vertex, or empty.
};

/// For every vertex the triangles around it, as a compressed list: those of vertex v are
/// `items[first[v]] ... items[first[v + 1] - 1]`, ascending.
struct VertexTriangles {
  std::vector<std::int32_t> first; ///< `n + 1` offsets.
  std::vector<std::int32_t> items; ///< `3 m` triangle numbers.
};

/// The triangles around each of `vertexCount` vertices. O(n + m).
VertexTriangles vertexTriangles(Eigen::Index vertexCount, const Triangles& triangles);

/// Throws `DataError` that names the first offending element when a coordinate is not finite or a triangle's
/// index is out of range. `where` names the mesh in the message. O(n + m).
void requireValid(const TriangleMesh& mesh, const std::string& where);

} // namespace viscera::geometry
