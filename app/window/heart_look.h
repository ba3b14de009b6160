#pragma once

#include "viscera/core/arrays.h"

/// How a heart with its cavities looks.
namespace viscera::app {

/// Blood in its textbook colours.
inline const Vec3 kArterialBlood(0.84, 0.16, 0.14), kVenousBlood(0.20, 0.36, 0.80);
/// Through the wall of an organ with cavities one sees them.
inline constexpr double kWallOpacity = 0.3;

} // namespace viscera::app
