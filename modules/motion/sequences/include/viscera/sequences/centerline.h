#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::sequences {

/// A place on a centreline and the plane across it.
struct CrossSection {
  Vec3 center = Vec3::Zero();
  Vec3 tangent = Vec3::UnitZ(); ///< Unit, along the line.
  Vec3 u = Vec3::UnitX();       ///< Unit; u, v and the tangent are right-handed.
  Vec3 v = Vec3::UnitY();

  /// The unit direction across the line at `angle` (rad) from u towards v.
  Vec3 across(double angle) const;
};

/// The middle line of a hollow organ by arc length: a centripetal Catmull-Rom curve through points, with
/// cross-sections that do not turn about it. Immutable; thread-safe.
class Centerline {
public:
  /// Through `points` (mm) in order. Throws `DataError` for fewer than two, for two neighbours at one place
  /// and for points that are not finite. O(length).
  explicit Centerline(const std::vector<Vec3>& points);

  /// mm
  double length() const { return arcs_.back(); }

  /// The cross-section at arc length `s` (mm), clamped to the line. O(log n).
  CrossSection at(double s) const;

  /// The arc length of the point of the line nearest to `point`. O(n).
  double nearest(const Vec3& point) const;

private:
  std::vector<double> arcs_;
  std::vector<CrossSection> sections_;
};

} // namespace viscera::sequences
