#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace viscera::medical_io {

/// Converts a text with the code extensions of DICOM (ISO 2022; PS3.5, 6.1.2.5) to UTF-8. `sets` are the
/// values of Specific Character Set, "\ISO 2022 IR 87"; escape sequences count even when they name a set that
/// is not among them. A set of letters above 127 that is named but not switched to counts from the beginning.
/// Nothing when a letter is in no set. O(n).
std::optional<std::string> fromIso2022(std::string_view sets, std::string_view text);

} // namespace viscera::medical_io
