#pragma once

#include <numbers>

namespace viscera::live {

/// Degrees in a radian.
inline constexpr double kDegrees = 180 / std::numbers::pi;

} // namespace viscera::live
