#pragma once

#include <string_view>

#include "file_bytes.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// The contents of a DICOM file.
enum class DicomKind {
  none,         ///< It is no DICOM file.
  image,        ///< Pixels, perhaps a slice of a scan.
  segmentation, ///< Segments: binary, fractional, or a label map; or the contours of a structure set.
  surface,      ///< An STL or OBJ file within.
  other,        ///< Nothing that Viscera reads.
};

/// The kind of an object by its SOP class; `image` when the class is empty, because only reading tells then.
DicomKind kindOfDicomClass(std::string_view classUid);

/// Whether a class is one of the two of segmentations (PS3.3, A.51 and A.51 with label maps, of 2024).
bool isSegmentationClass(std::string_view classUid);

/// Whether a class is that of contours drawn for radiotherapy (RT Structure Set, PS3.3, A.19).
bool isStructureSetClass(std::string_view classUid);

/// What DICOM calls objects of a class, the same in every language: "Ultrasound Image"; empty for a
/// class that has no name here.
std::string nameOfDicomClass(std::string_view classUid);

/// Throws `DataError` that names the kind of an object that is not read, and what can be done with it.
[[noreturn]] void failAsDicomObject(const FileBytes& file, std::string_view classUid);

} // namespace viscera::medical_io
