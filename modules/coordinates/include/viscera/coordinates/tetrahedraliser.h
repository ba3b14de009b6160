#pragma once

#include <functional>

#include "viscera/core/progress.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::coordinates {

/// A tetrahedral mesh that fills a closed surface.
struct SolidMesh {
  Points points; ///< `n x 3`, mm: first the points of the surface in their order, bit for bit, then new ones.
  geometry::Tetrahedra tetrahedra; ///< `t x 4` indices into `points`; each fills some space.
};

/// Fills a closed surface with tetrahedra of about `volumeMm3` at most. Triangles of the surface are kept;
/// points that no triangle uses lie inside and become corners. The same input gives the same mesh. Throws an
/// `Error` with the reason if that is not possible, and `Cancelled`. Called from several threads.
using Tetrahedraliser =
    std::function<SolidMesh(const geometry::TriangleMesh& surface, double volumeMm3, Progress& progress)>;

} // namespace viscera::coordinates
