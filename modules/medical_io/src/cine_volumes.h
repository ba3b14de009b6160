#pragma once

#include <filesystem>
#include <optional>

#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {

/// A file with volumes over time, other than DICOM, as a stack of slices over time; its planes are not named
/// yet. A phase's layers are decoded together. None for a file of one volume. Throws as `readScan`.
std::optional<CineStudy> cineOfVolumes(const std::filesystem::path& file, Progress& progress,
                                       const CineOptions& options);

} // namespace viscera::medical_io
