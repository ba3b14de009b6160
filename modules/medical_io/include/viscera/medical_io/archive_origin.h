#pragma once

#include <filesystem>
#include <optional>
#include <string>

/// Where a folder of images came from when an archive (PACS) sent them, so that they can be fetched again.
namespace viscera::medical_io {

/// The name of the file, in the folder of the images, that holds an `ArchiveOrigin`.
inline constexpr const char* kArchiveOriginFile = ".viscera-archive.json";

/// An archive as the user calls it, and what was fetched from it. It holds no address, user or password.
struct ArchiveOrigin {
  std::string archive;
  std::string studyUid;
  std::string seriesUid; ///< Empty: the whole study.
};

/// Notes it in a folder. Throws `CannotCreateError`.
void writeArchiveOrigin(const std::filesystem::path& folder, const ArchiveOrigin& origin);

/// What is noted in a folder; none where nothing is, or what is there is damaged. Reads one small file.
std::optional<ArchiveOrigin> readArchiveOrigin(const std::filesystem::path& folder);

} // namespace viscera::medical_io
