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
constexpr double kFactors[] = {1.02, 1.05, 1.1, 1.2, 1.5, 2, 3, 5, 10};
constexpr double kLowDegrees[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10};
/// The lower end stays while what would do is at most so many times as large.
constexpr double kLowStays = 6;

/// Bound of rounding: rad, and parts of the volume.
constexpr double kStill = 1e-5;

bool strains(const deformation::StressMap& map) {
  return map.rotationalStress.maxCoeff() > kStill || (map.volumeRatio.array() - 1).abs().maxCoeff() > kStill;
}

template <std::size_t count>
double stepAbove(const double (&steps)[count], double value) {
  const auto* step = std::lower_bound(std::begin(steps), std::end(steps), value);
  return step == std::end(steps) ? steps[count - 1] : *step;
}

/// The largest of 1, 2 and 5 times a power of ten that is at most `value`; of pascals, which have no usual
/// range.
double decimalBelow(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= value)
      return step * decade;
  return decade;
}

/// Likewise the smallest that is at least `value`.
double decimalAbove(double value) {
  const double below = decimalBelow(value);
  if (below >= value * (1 - kSame))
    return below;
  const double decade = std::pow(10, std::floor(std::log10(below * (1 + kSame))));
  return below < 1.5 * decade ? 2 * decade : below < 3 * decade ? 5 * decade : 10 * decade;
}

/// The upper end of a quantity that begins with 0.
double amountAbove(live::StressQuantity quantity, double most) {
  constexpr double kLeastKpa = 1e-3;
  return live::describe(quantity).ofMaterial ? decimalAbove(std::max(most, kLeastKpa))
                                             : stepAbove(kDegrees, most);
}

double lowAmount(live::StressQuantity quantity, double bulk, double high) {
  const double most = std::clamp(bulk, kLowestPart * high, kHighestPart * high) * (1 + kSame);
  if (live::describe(quantity).ofMaterial)
    return decimalBelow(most);
  const auto* above = std::upper_bound(std::begin(kLowDegrees), std::end(kLowDegrees), most);
  return above == std::begin(kLowDegrees) ? *above : *(above - 1);
}

scene::ValueRange logarithmicRange(live::StressQuantity quantity, scene::ValueRange bulk,
                                   scene::ValueRange before) {
  if (live::describe(quantity).ratio) {
    const double reach = std::max(bulk.high, bulk.low > 0 ? 1 / bulk.low : 0.0);
    const double most = std::pow(std::max(reach, 1.0), kWider);
    const bool stepped = before.high > 1 && std::abs(before.low * before.high - 1) < kSame;
    if (stepped && most <= before.high && std::log(most) >= kLeastFilled * std::log(before.high))
      return before;
    const double factor = stepAbove(kFactors, most);
    return {1 / factor, factor, true};
  }
  const double most = kWider * bulk.high;
  const bool same = before.high > 0 && most <= before.high && most >= kLeastFilled * before.high;
  const double high = same ? before.high : amountAbove(quantity, most);
  const double low = lowAmount(quantity, bulk.low, high);
  if (same && before.low > 0 && low >= before.low && low <= kLowStays * before.low)
    return before;
  return {low, high, true};
}

} // namespace

std::string StressLook::*colorsOf(live::StressQuantity quantity) {
  return live::describe(quantity).ratio ? &StressLook::ratioColors : &StressLook::amountColors;
}

scene::ColorMap stressColors(const std::string& name) {
  scene::ColorMap colors = scene::colorMapByName(name);
  colors.missing = kFolded;
  return colors;
}

scene::ValueRange steppedRange(live::StressQuantity quantity, scene::ValueRange bulk,
                               scene::ValueRange before) {
  if (quantity == live::StressQuantity::folded)
    return {0, 1};
  const bool ratio = live::describe(quantity).ratio;
  if (before.logarithmic)
    return logarithmicRange(quantity, bulk, before);
  const double most =
      kWider * (ratio ? std::max(std::abs(bulk.low - 1), std::abs(bulk.high - 1)) : bulk.high);
  const double reach = ratio ? before.high - 1 : before.high;
  const bool stepped = reach > 0 && std::abs(before.low - (ratio ? 1 - reach : 0)) < kSame;
  if (stepped && most <= reach && most >= kLeastFilled * reach)
    return before;
  return ratio ? scene::ValueRange{1 - stepAbove(kAroundOne, most), 1 + stepAbove(kAroundOne, most)}
               : scene::ValueRange{0, amountAbove(quantity, most)};
}

scene::ValueRange onScale(live::StressQuantity quantity, scene::ValueRange range, bool logarithmic) {
  range.logarithmic = logarithmic && quantity != live::StressQuantity::folded;
  if (range.logarithmic && valid(range) && !(range.low > 0))
    range.low = live::describe(quantity).ratio && range.high > 1 ? 1 / range.high : kLowestPart * range.high;
  return range;
}

scene::ValueRange joined(scene::ValueRange a, scene::ValueRange b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), a.logarithmic && b.logarithmic};
}

scene::ValueRange StressValues::legendRange() const {
  if (deformed_ || pinned_ || shared_)
    return range();
  const double rest = live::describe(measure_.quantity).ratio ? 1 : 0;
  return {rest, rest};
}

void StressValues::update(const live::StressFrame& frame, const StressLook& look,
                          std::optional<scene::ValueRange> shared) {
  shared_ = look.pinned ? std::nullopt : shared;
  const live::StressMeasure measure = look.measure();
  const bool peak = look.peak && frame.cycle && frame.cycle->peak;
  const deformation::StressMap none;
  const deformation::StressMap& map = !measure.known() ? none
                                      : peak           ? *frame.cycle->peak
                                      : frame.map      ? *frame.map
                                                       : none;
  live::quantityOf(map, measure, *values_);
  // A range belongs to one quantity on one mesh; the first one goes on from what the look has kept.
  if (colors_.name.empty() || measure_ != measure || mesh_ != frame.mesh || peak_ != peak)
    range_ = look.range;
  if (const std::string& name = look.*colorsOf(look.quantity); colors_.name != name)
    colors_ = stressColors(name);
  if (!look.pinned && range_.logarithmic != look.logarithmic)
    range_ = {0, 0}; // Chosen anew for the other scale.
  measure_ = measure;
  mesh_ = frame.mesh;
  peak_ = peak;
  summary_ = {};
  folded_ = 0;
  deformed_ = false;
  pinned_ = look.pinned && valid(look.range);
  if (!ready())
    return;
  deformed_ = strains(map);
  summary_ = live::summaryOf(*values_, frame.mesh->witnesses);
  folded_ = static_cast<int>((map.volumeRatio.head(frame.mesh->witnesses).array() <= 0).count());
  if (pinned_)
    range_ = onScale(look.quantity, look.range, look.logarithmic);
  else
    range_ = steppedRange(look.quantity, {summary_.percentile5, summary_.percentile95},
                          {range_.low, range_.high, look.logarithmic});
}

} // namespace viscera::presentation
