#include "viscera/presentation/stress_values.h"

#include <array>
#include <cstdint>

#include "viscera/presentation/value_steps.h"

namespace viscera::presentation {
namespace {

constexpr std::array<std::uint8_t, 3> kFolded = {232, 40, 200};

bool valid(scene::ValueRange range) {
  return range.high > range.low;
}

} // namespace

scene::ColorMap stressColors(live::StressQuantity quantity) {
  scene::ColorMap colors = scene::colorMapByName(live::describe(quantity).ratio ? "diverging" : "viridis");
  colors.missing = kFolded;
  return colors;
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
