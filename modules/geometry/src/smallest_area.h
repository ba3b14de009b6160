#pragma once

namespace viscera::geometry {

/// The area, as a fraction of the square of a surface's diagonal, below which a triangle counts as
/// degenerate.
inline constexpr double kSmallestRelativeArea = 1e-12;

} // namespace viscera::geometry
