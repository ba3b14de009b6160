#pragma once

#include <filesystem>
#include <functional>
#include <system_error>
#include <vector>

namespace viscera::medical_io {

/// Calls `visit` with the regular files of a folder and of those below it, four deep, in no particular order,
/// until it returns false. Folders that may not be read are passed over; returns the error of any other
/// folder whose files cannot be listed to the end.
std::error_code visitFiles(const std::filesystem::path& folder,
                           const std::function<bool(const std::filesystem::path&)>& visit);

/// The DICOM files with pixels, by name: of a folder and those below it; of a file, of the folder it is in.
/// Throws `NoInputError` when there is no such place or a folder cannot be listed to its end, so that no
/// series is taken for a shorter one, and `DataError` when there are none or too many.
std::vector<std::filesystem::path> dicomImages(const std::filesystem::path& fileOrFolder);

} // namespace viscera::medical_io
