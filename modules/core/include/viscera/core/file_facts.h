#pragma once

#include <cstdint>
#include <filesystem>

/// Asks for path and size of files without throwing; a file that has vanished has no bytes. For messages and
/// records, because the errors of `std::filesystem` are not written for users. For any thread.
namespace viscera {

/// `path` from the root on. A relative one without a working directory, which may have been removed, and an
/// empty one stay as they are.
std::filesystem::path absolutePath(const std::filesystem::path& path);

/// The length of a file in bytes; 0 when it is not there any more.
std::uintmax_t fileBytes(const std::filesystem::path& file);

} // namespace viscera
