#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates of the handles on the convex hull, to which the inner handles are added one by one
/// (thesis 3.1.3): each adds a weight of one, and the earlier ones change by `q_i . d + k`, with the vector d
/// that keeps the balance. `k`: `one`, or `norm` for the length of d, which the thesis only proposes: no
/// number is then negative, but d solves a quadratic equation, and where it has no positive root the point
/// has no coordinates. O(triangles + inner handles x n) a point.
class IncrementalApproach final : public PointwiseSystem {
public:
  IncrementalApproach();
};

} // namespace viscera::coordinates
