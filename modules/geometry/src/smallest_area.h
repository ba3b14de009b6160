#pragma once

namespace viscera::geometry {

/// Of the square of a surface's diagonal: a smaller triangle has no area.
inline constexpr double kSmallestRelativeArea = 1e-12;

} // namespace viscera::geometry
