#pragma once

namespace viscera::app {

/// The largest distance, in logical pixels, between the press and the release of a mouse click.
inline constexpr double kClickDistance = 4;

} // namespace viscera::app
