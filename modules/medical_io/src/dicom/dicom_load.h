#pragma once

#include <cstdint>

#include "file_bytes.h"

class DcmFileFormat;

namespace viscera::medical_io {

/// Values that are longer stay on the disk until they are read.
inline constexpr std::uint32_t kLongestLoadedValue = 4096;

/// Loads a DICOM file, with or without preamble and group 2. Elements that are known to the standard but
/// written without their type (VR UN) get it, at every depth, as the data dictionary states it. Takes memory
/// for what is in the file. Throws `DataError` for a damaged file. For any thread.
void loadDicom(DcmFileFormat& format, const FileBytes& file);

/// Loads what lies before the pixels, of a file that may be cut off in them, or in what lies before them.
/// Throws `DataError` for a deflated file that would be too large.
void loadDicomBeforePixels(DcmFileFormat& format, const FileBytes& file);

} // namespace viscera::medical_io
