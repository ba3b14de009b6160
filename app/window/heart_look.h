#pragma once

#include "viscera/core/arrays.h"

/// Default colours and transparency of a heart with cavities.
namespace viscera::app {

/// Blood in its textbook colours.
inline const Vec3 kArterialBlood(0.84, 0.16, 0.14), kVenousBlood(0.20, 0.36, 0.80);
/// Opacity of the wall of an organ with cavities, so that the cavities can be seen through it.
inline constexpr double kWallOpacity = 0.3;

} // namespace viscera::app
