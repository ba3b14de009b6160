#pragma once

#include <cstdint>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {

/// The result of `closeHoles`: a surface without holes, and how many were filled.
struct ClosedSurface {
  TriangleMesh mesh; ///< The given points first, unchanged; then one for the middle of every larger hole.
  int holes = 0;     ///< How many were filled.
  /// The vertices of each hole's rim in their order along it, the first not repeated.
  std::vector<std::vector<std::int32_t>> rims = {};
};

/// Fills every hole of an open surface by a cap: one triangle where three edges are open, else a fan around
/// the mean of the rim (weighted by the lengths of its edges, so that a rim that is sampled unevenly does not
/// pull it aside). Caps run the same way round as the triangles beside them. A point where two rims touch is
/// taken as part of both. Vertex colours go on into the caps. A closed surface is returned unchanged.
///
/// The middles lie in the convex hull of the surface, so a hull that encloses the surface encloses the caps
/// too. Throws `DataError` when the triangles beside a rim do not run the same way round. Expects valid
/// indices. O(m log m).
ClosedSurface closeHoles(const TriangleMesh& mesh);

} // namespace viscera::geometry
