#pragma once

#include "viscera/core/parallel.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// Unit vertex normals, `n x 3`: the area-weighted mean of the triangles around each vertex, outward for an
/// outward surface; zero where all triangles around a vertex are degenerate. Single precision because only
/// drawing needs them.
using Normals = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Fills `normals` (resized to `n x 3`) for `points`. `around` comes from `vertexTriangles`. Bitwise
/// independent of the number of threads. O(m); may be called from several threads with different outputs.
void vertexNormals(const Points& points, const Triangles& triangles, const VertexTriangles& around,
                   Normals& normals, Threads threads = {});

/// The same for one use.
Normals vertexNormals(const TriangleMesh& mesh);

} // namespace viscera::geometry
