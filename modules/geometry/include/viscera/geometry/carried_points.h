#pragma once

#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"

namespace viscera::geometry {

/// Points that move with the vertices of surfaces around them, for what is drawn inside an organ and has no
/// handles of its own. A point that is a vertex is where that vertex is. Any other point is a fixed mean of
/// vertices near it, of moving least squares with linear terms (Levin 1998, doi
/// 10.1090/S0025-5718-98-00974-0): it follows every affine motion of them exactly, and a smooth motion with
/// an error that grows with the square of its distance to the nearest vertices. Immutable; thread-safe.
///
///     const CarriedPoints carried(inner.points, outer.points);
///     Points now;
///     carried.at(outerNow, now);
class CarriedPoints {
public:
  /// `rest` (`n x 3`) and the vertices that carry them (`m x 3`), mm, at one time. Throws `DataError` for
  /// fewer than four vertices. O(m + n log m) where vertices are evenly spread.
  CarriedPoints(const Points& rest, const Points& carriers, Threads threads = {});

  /// Writes the points as they are when the vertices, in the same order, are at `carriers`; `out` gets n
  /// rows. Throws `UsageError` for another number of vertices. O(n), some hundred vertices a point at most.
  void at(const Points& carriers, Points& out, Threads threads = {}) const;

  Eigen::Index size() const { return static_cast<Eigen::Index>(first_.size()) - 1; }
  /// Whether a point is one of the vertices.
  bool isVertex(Eigen::Index point) const;

private:
  Eigen::Index carriers_;
  std::vector<std::int64_t> first_; ///< Where each point's part of the lists below begins.
  std::vector<std::int32_t> vertices_;
  std::vector<double> weights_;
};

} // namespace viscera::geometry
