#pragma once

#include <filesystem>

namespace viscera::medical_io {

/// What a DICOM file holds, as far as its first bytes say.
enum class DicomKind { none, image, segmentation, other };

/// By the mark behind 128 bytes and the class that stands in the group before the data set; without parsing.
/// `other` for what holds no pixels, such as a folder's table of contents or a report. Cheap.
DicomKind dicomKind(const std::filesystem::path& file);

/// Whether a folder, or one below it, has a DICOM file with pixels that is no segmentation. Stops at the
/// first.
bool hasDicomImages(const std::filesystem::path& folder);

/// Whether a scan at that place is one of DICOM: a folder, or a DICOM file.
bool isDicomPlace(const std::filesystem::path& fileOrFolder);

} // namespace viscera::medical_io
