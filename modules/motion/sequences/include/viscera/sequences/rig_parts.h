#pragma once

#include <functional>
#include <vector>

#include "viscera/core/arrays.h"

/// Helper functions to place handles in rings and boxes around organs.
namespace viscera::sequences {

/// The surface of an organ or of a part of it as a function of the point (mm, LPS): negative inside, about
/// the distance in mm near the surface. May be called from several threads.
using AnatomySurface = std::function<double(const Vec3& point)>;

/// `count` places around `center` in the plane across `axis` (not zero), evenly spread.
std::vector<Vec3> ringAround(const Vec3& center, const Vec3& axis, double radius, int count);

/// The eight corners of a box, mm.
std::vector<Vec3> cornersOf(const Bounds& box);

/// The positions of handles as a pose, `n x 3` mm. O(n).
template <class Handle>
Points positionsOf(const std::vector<Handle>& handles) {
  Points points(static_cast<Eigen::Index>(handles.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = handles[static_cast<std::size_t>(i)].position;
  return points;
}

} // namespace viscera::sequences
