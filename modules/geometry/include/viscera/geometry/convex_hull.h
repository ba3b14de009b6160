#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "viscera/core/arrays.h"

/// Computes convex hulls and Delaunay tetrahedra of points, by Qhull.
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

/// The convex hull of a set of points, by Qhull. Immutable; may be called from several threads.
class ConvexHull {
public:
  /// `points` is `n x 3`, mm. Throws `DataError` for fewer than four points, for points that all lie in one
  /// plane (flat to 1e-9 of their size) or that are not finite. O(n log n).
  explicit ConvexHull(const Points& points);

  /// Outward triangles, indices into the points given.
  const Triangles& triangles() const { return triangles_; }

  /// `f x 4` facet planes: outward unit normal and offset, `n.p + offset <= 0` inside. Coplanar triangles
  /// share one.
  const Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>& planes() const { return planes_; }

  /// Largest signed distance to a facet's plane in mm: negative inside, positive outside. O(f).
  double signedDistance(const Vec3& point) const;

  /// Size of the hull's points, for tolerances: the diagonal of their box, mm.
  double diagonal() const { return diagonal_; }

  /// The rows of `points` whose signed distance is above `margin` (mm), ascending. O(n f).
  std::vector<int> outside(const Points& points, double margin = 0) const;

private:
  Triangles triangles_;
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> planes_;
  double diagonal_ = 0;
};

} // namespace viscera::geometry
