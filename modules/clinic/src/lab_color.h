#pragma once

#include <array>
#include <cstdint>

#include "viscera/core/arrays.h"

namespace viscera::clinic {

/// A colour (0 to 1, sRGB) as DICOM writes it: CIELab under D50, each number over its whole range in 16 bits
/// (PS3.3, C.10.7.1.1).
std::array<std::uint16_t, 3> dicomLab(const Vec3& color);

} // namespace viscera::clinic
