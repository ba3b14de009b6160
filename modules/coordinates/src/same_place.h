#pragma once

namespace viscera::coordinates {

/// Of the size of the handles, or of the cage: a point this near to a handle is at it.
inline constexpr double kSamePlace = 1e-12;

} // namespace viscera::coordinates
