#pragma once

#include <filesystem>

namespace viscera::medical_io {

/// The contents of a DICOM file, judged by its first bytes.
enum class DicomKind { none, image, segmentation, other };

/// Judges by the mark after 128 bytes and the class in the group before the data set, without parsing.
/// `other` for what holds no pixels, such as a folder's table of contents or a report. Cheap.
DicomKind dicomKind(const std::filesystem::path& file);

/// Whether a folder, or one below it, has a DICOM file with pixels that is no segmentation. Stops at the
/// first.
bool hasDicomImages(const std::filesystem::path& folder);

/// Whether a scan at that place is one of DICOM: a folder, or a DICOM file.
bool isDicomPlace(const std::filesystem::path& fileOrFolder);

} // namespace viscera::medical_io
