#pragma once

#include <optional>

#include "viscera/core/arrays.h"

class DcmItem;

namespace viscera::medical_io {

/// The recommended colour (CIELab, PS3.3, C.10.7.1.1) of a segment or a surface, 0 to 1 in sRGB; none when it
/// states none. Colours that a screen cannot show are clipped.
std::optional<Vec3> recommendedColor(DcmItem& item);

} // namespace viscera::medical_io
