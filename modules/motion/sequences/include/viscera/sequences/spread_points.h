#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::sequences {

/// Picks points out of `candidates` (`n x 3`), the one farthest from all before it first, until every
/// candidate is within `reach` (mm) of a pick or of one of `present` (`m x 3`). Deterministic. O(n (picks +
/// m)).
std::vector<Vec3> spreadPoints(const Points& candidates, const Points& present, double reach);

/// The rows of `points` for which `keep` returns true.
template <class Keep>
Points rowsWhere(const Points& points, Keep keep) {
  Points kept(points.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (keep(Vec3(points.row(i).transpose())))
      kept.row(count++) = points.row(i);
  kept.conservativeResize(count, 3);
  return kept;
}

/// `point` moved by `distance` (mm) straight away from the surface.
template <class Surface>
Vec3 movedOff(const Surface& surface, const Vec3& point, double distance) {
  constexpr double kStep = 0.5;
  Vec3 slope;
  for (int k = 0; k < 3; ++k)
    slope[k] = surface(point + kStep * Vec3::Unit(k)) - surface(point - kStep * Vec3::Unit(k));
  return point + distance * slope.stableNormalized();
}

/// The box of the points, larger by `margin` of its diagonal on every side.
Bounds grownBox(const Points& points, double margin);

} // namespace viscera::sequences
