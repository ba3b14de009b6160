#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "dicom/dicom_header.h"
#include "viscera/core/error.h"
#include "viscera/core/progress.h"

namespace viscera::medical_io {

/// The headers of several files, one for each; of a damaged one only its name and an error.
struct FolderHeaders {
  std::vector<std::filesystem::path> files;
  std::vector<DicomHeader> headers;
  std::vector<std::optional<DataError>> errors;
};

/// Reads the headers on several threads; progress runs from 0 to `until`. Throws `NoInputError`, `Cancelled`.
FolderHeaders readDicomHeaders(std::vector<std::filesystem::path> files, Progress& progress, double until);

} // namespace viscera::medical_io
