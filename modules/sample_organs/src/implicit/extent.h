#pragma once

#include <cmath>
#include <limits>

#include "viscera/core/arrays.h"

namespace viscera::sample_organs {

/// An axis-parallel box that grows with what is put into it; empty at first (low above high).
struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = Vec3::Constant(std::numeric_limits<double>::lowest());

  bool empty() const { return (low.array() > high.array()).any(); }
  void include(const Vec3& point);
  void include(const Extent& other);
  /// A ball of `radius` mm around `point`.
  void includeBall(const Vec3& point, double radius);
  /// By `margin` mm on every side.
  Extent grown(double margin) const;
  Extent intersectedWith(const Extent& other) const;
  Vec3 size() const { return high - low; }
  /// The corner with the high coordinate of axis i where bit i of `index` is set.
  Vec3 corner(int index) const;

  /// Distance in mm from a point to the box, 0 inside.
  double distance(const Vec3& point) const { return std::sqrt(distance2(point)); }
  double distance2(const Vec3& point) const {
    return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
  }
};

} // namespace viscera::sample_organs
