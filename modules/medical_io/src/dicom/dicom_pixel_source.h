#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "dicom/dicom_pixels.h"

class DcmFileFormat;

namespace viscera::medical_io {

/// The interface that reads pixels of an opened file, implemented for each kind of compression. `header`
/// outlives it.
class DicomPixelSource {
public:
  virtual ~DicomPixelSource() = default;
  /// Reads as `DicomPixelReader::read`.
  virtual DicomPixels read(int frame) = 0;
};

/// A byte for each of `count` bits from number `first` on, the lowest bit of a byte first; `bits` has them.
std::string bytesOfBits(std::string_view bits, std::uint64_t first, std::uint64_t count);

/// JPEG 2000, unpacked by OpenJPEG. Throws `DataError`.
std::unique_ptr<DicomPixelSource> jpeg2000Pixels(const DicomHeader& header,
                                                 std::shared_ptr<DcmFileFormat> format);

/// RLE. Throws `DataError`.
std::unique_ptr<DicomPixelSource> rlePixels(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format);

} // namespace viscera::medical_io
