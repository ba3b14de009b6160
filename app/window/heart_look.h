#pragma once

namespace viscera::app {

/// Opacity of the wall of an organ with cavities, so that the cavities can be seen through it.
inline constexpr double kWallOpacity = 0.3;

} // namespace viscera::app
