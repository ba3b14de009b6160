#pragma once

#include <array>

namespace viscera::deformation {

/// The corners of the four faces, outward in a positive tetrahedron.
inline constexpr std::array<std::array<int, 3>, 4> kFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

} // namespace viscera::deformation
