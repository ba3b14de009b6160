#pragma once

#include <cstdint>
#include <optional>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// `m x 4` vertex indices of tetrahedra, row major.
using Tetrahedra = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// The triangles of a convex hull, outward, and the plane of each.
struct HullFacets {
  Triangles triangles;
  /// `f x 4`: outward unit normal and offset, `n.p + offset <= 0` inside.
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> planes;
};

/// The convex hull of points, by Qhull, for inner loops: no checks, no message. Facets with more than three
/// corners are triangulated. Over unit vectors it is their Delaunay triangulation on the sphere, and a
/// plane's normal points to the centre of the circle through the three. Nothing where Qhull finds no hull.
/// O(n log n).
std::optional<HullFacets> hullFacets(const Points& points);

/// The Delaunay tetrahedra of `n x 3` points, by Qhull. Throws `DataError` when there are none. O(n^2).
Tetrahedra delaunayTetrahedra(const Points& points);

} // namespace viscera::geometry
