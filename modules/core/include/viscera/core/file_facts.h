#pragma once

#include <cstdint>
#include <filesystem>

/// Facts on files for messages and records, which are told without an error of their own: a file may vanish
/// at any moment. The functions of `std::filesystem` that throw do it in words that are not for users. From
/// any thread.
namespace viscera {

/// `path` from the root on. A relative one without a working directory, which may have been removed, and an
/// empty one stay as they are.
std::filesystem::path absolutePath(const std::filesystem::path& path);

/// The length of a file in bytes; 0 when it is not there any more.
std::uintmax_t fileBytes(const std::filesystem::path& file);

} // namespace viscera
