#pragma once

#include <memory>

#include "dicom/dicom_pixels.h"

class DcmFileFormat;

namespace viscera::medical_io {

/// The interface that reads pixels of an opened file, implemented for each kind of compression. `header`
/// outlives it.
class DicomPixelSource {
public:
  virtual ~DicomPixelSource() = default;
  /// As `DicomPixelReader::read`.
  virtual DicomPixels read(int frame) = 0;
};

/// JPEG 2000, unpacked by OpenJPEG. Throws `DataError`.
std::unique_ptr<DicomPixelSource> jpeg2000Pixels(const DicomHeader& header,
                                                 std::shared_ptr<DcmFileFormat> format);

/// RLE. Throws `DataError`.
std::unique_ptr<DicomPixelSource> rlePixels(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format);

} // namespace viscera::medical_io
