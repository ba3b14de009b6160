#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Coordinates from a wire (a polygonal line) through the projections of fixed points of n-space onto the
/// balanced vectors, cut by the positive orthant; the mean of the remaining line, weighted by length (thesis
/// 3.3.2). `points`: `p1` the axes, `p2` all ones but one zero, `p3` the axes and their opposites.
/// `connection`: `cycle` (the thesis's C1, or C2 with `p3`) or `complete` (C3). The wire often misses the
/// orthant, and the point then has no coordinates. O(n^2), for the complete graph O(n^3) a point.
class WireApproach final : public PointwiseSystem {
public:
  WireApproach();
};

} // namespace viscera::coordinates
