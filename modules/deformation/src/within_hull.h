#pragma once

namespace viscera::deformation {

/// Of the hull's diagonal, from its facets: what is nearer to one is not inside.
inline constexpr double kWithinHull = 1e-6;

} // namespace viscera::deformation
