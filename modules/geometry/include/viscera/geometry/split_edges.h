#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// Splits long edges of a surface without changing its shape: every edge longer than `longest` (mm) is
/// halved, again and again, and its triangles with it. The first points are those of `mesh`; no triangle is
/// left out. Edges stop being halved when there would be more than `mostTriangles`. Expects valid indices.
/// Without colours. O(size of the result).
TriangleMesh splitLongEdges(const TriangleMesh& mesh, double longest, int mostTriangles);

} // namespace viscera::geometry
