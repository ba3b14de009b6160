#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {

/// The cine slices of one study in DICOM files, and what was left out; its planes are not named yet. None
/// without such slices. `root` is the folder that the names of files in findings begin behind. Throws as
/// `findCineStudy`.
std::optional<CineStudy> dicomCine(const std::filesystem::path& root,
                                   const std::vector<std::filesystem::path>& files, Progress& progress,
                                   const CineOptions& options);

} // namespace viscera::medical_io
