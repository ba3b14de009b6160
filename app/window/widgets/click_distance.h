#pragma once

namespace viscera::app {

/// Logical pixels: a press and a release that are nearer to each other are a click.
inline constexpr double kClickDistance = 4;

} // namespace viscera::app
