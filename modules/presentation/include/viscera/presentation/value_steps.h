#pragma once

#include "viscera/live/stress_quantity.h"
#include "viscera/scene/color_map.h"

namespace viscera::presentation {

/// The range of a legend for a quantity of which nine tenths lie in `bulk`: from a list of round steps, so
/// that it does not creep while something moves, and half as wide again as the bulk: a few extreme places do
/// not take the colours from all others. Ratios lie around 1. It grows at once; it shrinks only when what
/// would do fills less than `kLeastFilled` of `before`.
scene::ValueRange steppedRange(live::StressQuantity quantity, scene::ValueRange bulk,
                               scene::ValueRange before);

inline constexpr double kLeastFilled = 0.35;

} // namespace viscera::presentation
