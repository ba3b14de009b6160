#pragma once

#include <string>

#include "viscera/core/arrays.h"

namespace viscera::app::cli {

/// Parses a position from the command line: "12,-40,310" is x, y and z in mm, LPS. Throws `UsageError` that
/// quotes `option` ("--at") and the text for any other text.
Vec3 positionOf(const std::string& text, const std::string& option);

} // namespace viscera::app::cli
