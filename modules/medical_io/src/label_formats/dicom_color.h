#pragma once

#include <cstdint>

#include "viscera/core/arrays.h"

namespace viscera::medical_io {

/// The colour, 0 to 1 in sRGB, of a CIELab value as DICOM stores it (PS3.3, C.10.7.1.1: each of the three
/// over its whole range in 16 bits, under the illuminant D50). Colours that a screen cannot show are clipped.
Vec3 colorOfDicomLab(std::uint16_t l, std::uint16_t a, std::uint16_t b);

} // namespace viscera::medical_io
