#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Coordinates by constrained least squares: of all balanced vectors the one nearest to a target (thesis
/// 3.3.1). Parameters:
/// * `target`: one, the inverse distance, or the closeness `1 - d / largest d`.
/// * `positivity`: the treatment of negative numbers.
///   - `exact` (ours): the quadratic programme (3.25) solved to the end, by Newton's method on its dual,
///   which
///     has three unknowns. Unique, positive, continuous.
///   - `free`: nothing (3.21).
///   - `local-test`: the feasible choice of handles without influence that has the fewest of them, point by
///     point. Of several the one nearest to the target. Gives up after 20,000 choices a point.
///   - `global-test`: the same choice for all points of the binding.
///   - `iterative-test`: negative ones are set to zero and the rest solved again.
///   - `iterative`: the target is shifted by the most negative number of all points until none is left; at
///     most 200 times, then points that still have one have no coordinates.
/// * `shift`: for `iterative`, the target is raised; or lowered, as the thesis prints it.
///
/// With the sign of the multipliers tested as well, the solution of (3.25) is unique; the thesis's local test
/// leaves it out, which is where its jumps come from. O(n) a point but for the tests, which try sets of
/// handles.
class LagrangeMinimisation final : public PointwiseSystem {
public:
  LagrangeMinimisation();
};

} // namespace viscera::coordinates
