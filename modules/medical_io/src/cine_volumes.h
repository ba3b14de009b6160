#pragma once

#include <filesystem>
#include <optional>

#include "viscera/medical_io/cine_study.h"

namespace viscera::medical_io {

/// Volumes over time, of a file or of DICOM series that are the phases of one scan, as a stack of slices over
/// time; its planes are not named yet. A phase's layers are decoded together, and `options.keptBytes` of
/// phases stay. None for a place with one volume. Throws as `readScan`.
std::optional<CineStudy> cineOfVolumes(const std::filesystem::path& place, Progress& progress,
                                       const CineOptions& options);

} // namespace viscera::medical_io
