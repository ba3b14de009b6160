#include "viscera/presentation/stress_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace viscera::presentation {
namespace {

constexpr std::array<std::uint8_t, 3> kFolded = {232, 40, 200};

bool valid(scene::ValueRange range) {
  return range.high > range.low;
}

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

scene::ColorMap stressColors(live::StressQuantity quantity) {
  scene::ColorMap colors = scene::colorMapByName(live::describe(quantity).ratio ? "diverging" : "viridis");
  colors.missing = kFolded;
  return colors;
}

scene::ValueRange steppedRange(live::StressQuantity quantity, scene::ValueRange bulk,
                               scene::ValueRange before) {
  if (quantity == live::StressQuantity::folded)
    return {0, 1};
  const bool ratio = live::describe(quantity).ratio;
  const double most =
      kWider * (ratio ? std::max(std::abs(bulk.low - 1), std::abs(bulk.high - 1)) : bulk.high);
  const double reach = ratio ? before.high - 1 : before.high;
  const bool stepped = reach > 0 && std::abs(before.low - (ratio ? 1 - reach : 0)) < kSame;
  if (stepped && most <= reach && most >= kLeastFilled * reach)
    return before;
  return ratio ? scene::ValueRange{1 - stepAbove(kAroundOne, most), 1 + stepAbove(kAroundOne, most)}
               : scene::ValueRange{0, stepAbove(kDegrees, most)};
}

void StressValues::update(const live::StressFrame& frame, const StressLook& look) {
  const bool peak = look.peak && frame.peak;
  const deformation::StressMap none;
  const deformation::StressMap& map = peak ? frame.peak->map : frame.map ? *frame.map : none;
  live::quantityOf(map, look.quantity, *values_);
  // A range belongs to one quantity on one mesh; the first one goes on from what the look has kept.
  if (colors_.name.empty() || quantity_ != look.quantity || mesh_ != frame.mesh || peak_ != peak) {
    if (colors_.name.empty() || quantity_ != look.quantity)
      colors_ = stressColors(look.quantity);
    range_ = look.range;
  }
  quantity_ = look.quantity;
  mesh_ = frame.mesh;
  peak_ = peak;
  summary_ = {};
  folded_ = 0;
  if (!ready())
    return;
  summary_ = live::summaryOf(*values_, frame.mesh->witnesses);
  folded_ = static_cast<int>((map.volumeRatio.head(frame.mesh->witnesses).array() <= 0).count());
  if (look.pinned && valid(look.range))
    range_ = look.range;
  else
    range_ = steppedRange(look.quantity, {summary_.percentile5, summary_.percentile95}, range_);
}

} // namespace viscera::presentation
