#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// The convex hull of a set of points, by Qhull. Immutable; may be asked from several threads.
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
