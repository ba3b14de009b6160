#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "timed_volumes.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// `listScans` of a DICOM folder or file.
std::vector<ScanSeries> listDicomScans(const std::filesystem::path& fileOrFolder, Progress& progress);

/// `readScan` of a DICOM folder or file.
Scan readDicomScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options, Progress& progress);

/// The volumes over time of a DICOM folder or file: the phases of a series, or series that are the phases of
/// one scan. None of one volume. Throws as `readScan`; `Cancelled`.
std::optional<TimedVolumes> dicomVolumes(const std::filesystem::path& fileOrFolder, const std::string& series,
                                         Progress& progress);

} // namespace viscera::medical_io
