#include "viscera/presentation/value_steps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace viscera::presentation {
namespace {

constexpr double kWider = 1.5;
constexpr double kSame = 1e-9; ///< Of ends that are the same but for rounding.
constexpr double kDegrees[] = {1, 2, 5, 10, 15, 20, 30, 45, 60, 90};
constexpr double kAroundOne[] = {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1};

template <std::size_t count>
double stepAbove(const double (&steps)[count], double value) {
  const auto* step = std::lower_bound(std::begin(steps), std::end(steps), value);
  return step == std::end(steps) ? steps[count - 1] : *step;
}

} // namespace

scene::ValueRange steppedRange(live::StressQuantity quantity, scene::ValueRange bulk,
                               scene::ValueRange before) {
  if (quantity == live::StressQuantity::folded)
    return {0, 1};
  const bool ratio = live::describe(quantity).ratio;
  const double most =
      kWider * (ratio ? std::max(std::abs(bulk.low - 1), std::abs(bulk.high - 1)) : bulk.high);
  const double reach = ratio ? before.high - 1 : before.high;
  const bool valid = reach > 0 && std::abs(before.low - (ratio ? 1 - reach : 0)) < kSame;
  if (valid && most <= reach && most >= kLeastFilled * reach)
    return before;
  return ratio ? scene::ValueRange{1 - stepAbove(kAroundOne, most), 1 + stepAbove(kAroundOne, most)}
               : scene::ValueRange{0, stepAbove(kDegrees, most)};
}

} // namespace viscera::presentation
