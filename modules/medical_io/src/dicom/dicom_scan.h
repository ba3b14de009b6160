#pragma once

#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// `listScans` of a DICOM folder or file.
std::vector<ScanSeries> listDicomScans(const std::filesystem::path& fileOrFolder, Progress& progress);

/// `readScan` of a DICOM folder or file.
Scan readDicomScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options, Progress& progress);

} // namespace viscera::medical_io
