#pragma once

#include <string>

#include "viscera/core/arrays.h"

namespace viscera::app::cli {

/// A place as it is written on the command line: "12,-40,310" is x, y and z in mm, LPS. Throws `UsageError`
/// that shows `option` ("--at") with the text for any other text.
Vec3 positionOf(const std::string& text, const std::string& option);

} // namespace viscera::app::cli
