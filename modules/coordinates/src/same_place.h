#pragma once

namespace viscera::coordinates {

/// Tolerance, relative to the size of the handles or of the cage, below which a point coincides with a
/// handle.
inline constexpr double kSamePlace = 1e-12;

} // namespace viscera::coordinates
