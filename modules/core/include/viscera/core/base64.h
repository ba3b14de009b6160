#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace viscera {

/// The bytes as base64 (RFC 4648) in one line, padded with "=". O(bytes); for any thread.
std::string base64Of(std::string_view bytes);

/// The bytes that such a text stands for. Nothing for another character, also white space, and for a text
/// that ends within a group of four. O(text); for any thread.
std::optional<std::string> bytesOfBase64(std::string_view text);

} // namespace viscera
