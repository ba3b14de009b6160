#pragma once

#include <filesystem>
#include <string>

#include "dicom/dicom_kinds.h"

namespace viscera::medical_io {

/// Judges by the first elements of the file, which state its class, without parsing. Files without a preamble
/// are recognised, too. `other` for what holds no pixels, such as a folder's table of contents or a report.
/// Cheap.
DicomKind dicomKind(const std::filesystem::path& file);

/// The SOP class that the beginning of a DICOM file states; empty for any other file, or when it states none.
std::string dicomClass(const std::filesystem::path& file);

/// Whether a folder, or one below it, has a DICOM file with pixels that is no segmentation. Stops at the
/// first.
bool hasDicomImages(const std::filesystem::path& folder);

/// Whether a scan at that place is one of DICOM: a folder, or a DICOM file.
bool isDicomPlace(const std::filesystem::path& fileOrFolder);

} // namespace viscera::medical_io
