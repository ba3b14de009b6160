#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// Points near a surface that go with it: each moves by the mean of the displacements of its nearest
/// vertices, weighted by 1 / (distance^2 + 1 mm^2). Immutable; thread-safe.
class CarriedPoints {
public:
  /// `points`: `n x 3`; `surface`: `m x 3`, the vertices at rest, one at least; mm. O(n m).
  CarriedPoints(const Points& points, const Points& surface);

  /// The points where the vertices are `surface` (`m x 3`). O(n).
  Points at(const Points& surface) const;

private:
  static constexpr Eigen::Index kCarriers = 32;

  /// The vertices that carry one point.
  struct Carriers {
    std::vector<Eigen::Index> vertices;
    std::vector<double> weights; ///< Their sum is 1.
    Vec3 offset;                 ///< The point less their weighted mean, at rest.
  };
  std::vector<Carriers> carriers_;
};

} // namespace viscera::geometry
