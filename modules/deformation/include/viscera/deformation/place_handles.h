#pragma once

#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// The fewest handles that `placeHandles` places: the eight corners of a box when they enclose the organ,
/// else the four of a tetrahedron, to which an organ could be bound. The window, the command line and Python
/// have the same limit.
constexpr int fewestHandles(bool enclosing) {
  return enclosing ? 8 : 4;
}

/// The options of `placeHandles`: number, distance and further settings.
struct Placement {
  int count = 30;        ///< All handles, the enclosing eight included; at least `fewestHandles(enclosing)`.
  bool enclosing = true; ///< The eight corners of a box around the organ come first: nothing lies outside.
  double offsetFraction = 0.03; ///< Distance of a handle from the surface, as a part of the organ's diagonal.
  double boxMargin = 0.15;      ///< Distance of the box from the organ, as a part of the organ's diagonal.
};

/// Places handles evenly spread around an organ, just off its surface: farthest-point samples of the
/// vertices, the most prominent vertex first, each moved outward along its normal. A handle never lies on or
/// inside the surface, because no positive linearly precise coordinate is smooth at a handle inside the hull
/// (design notes, science section 1). Deterministic. Throws `DataError` for a mesh with fewer than four
/// vertices or a count too small. O(n count). Returns `count x 3`.
Points placeHandles(const geometry::TriangleMesh& organ, const Placement& placement = {});

/// Places handles around several organs, each of which gets handles in proportion to the area of its surface
/// and at its own distance (`offsetFraction` of its diagonal); none lies on or inside another organ. Handles
/// for which an organ has no room go to the larger ones. The box encloses all organs. Deterministic; of one
/// organ the same as above. Throws `DataError` as above, and where all organs together have no room.
/// O(vertices of an organ x its handles + handles x all vertices).
Points placeHandles(const std::vector<const geometry::TriangleMesh*>& organs, const Placement& placement);

/// The eight corners of the organ's box grown by `margin` of its diagonal, `8 x 3`.
Points enclosingHandles(const Points& organPoints, double margin = 0.15);

} // namespace viscera::deformation
