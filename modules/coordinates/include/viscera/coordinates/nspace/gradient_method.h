#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Coordinates by gradient ascent: raises the smallest number of a balanced vector along its steepest
/// direction; where others tie with it they are raised together (thesis 3.3.4). Parameters:
/// * `stop`: `inside` stops as soon as no number is negative; `highest` goes on until the smallest number no
///   longer rises, and takes the direction if it rises without limit. The thesis describes both. It promises
///   continuity, which holds for `inside`; `highest` jumps where the order of the ties changes.
/// * `seed`: of the random positive vector whose projection is the start, the same for all points; 0 starts
///   from all ones.
///
/// Points at which the ascent ends with a negative number have no coordinates. O(n^2) a point.
class GradientMethod final : public PointwiseSystem {
public:
  GradientMethod();
};

} // namespace viscera::coordinates
