#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace viscera::document {

/// The SHA-256 of these bytes one after the other, in hexadecimal.
std::string sha256(std::initializer_list<std::string_view> pieces);

/// The SHA-256 of a file's bytes, in hexadecimal; empty when it cannot be read. Some 300 MB a second.
std::string sha256OfFile(const std::filesystem::path& file);

} // namespace viscera::document
