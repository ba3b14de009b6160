#pragma once

#include <cstdint>
#include <string_view>

#include "viscera/core/arrays.h"

namespace viscera::medical_io {

/// The colour, 0 to 1, that atlases give the organ of that name ("kidney_left", "Liver", "left kidney"); for
/// any other name one that depends on the label alone and differs well from its neighbours'.
Vec3 anatomyColor(std::string_view name, std::int64_t label);

} // namespace viscera::medical_io
