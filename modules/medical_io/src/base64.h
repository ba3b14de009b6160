#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace viscera::medical_io {

/// The bytes that `text` stands for; white space is skipped. Nothing when a character does not belong there
/// or the text ends within a group.
std::optional<std::string> decodeBase64(std::string_view text);

} // namespace viscera::medical_io
