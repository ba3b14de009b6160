#pragma once

#include <memory>
#include <string>

#include "dicom/dicom_header.h"

class DcmFileFormat;

namespace viscera::medical_io {

/// The pixels of one frame, unpacked.
struct DicomPixels {
  std::string bytes; ///< In the machine's byte order, row by row; pixels of one bit take a byte each.
  DicomPixelFormat format;
};

class DicomPixelSource;

/// The pixels of a file, frame by frame. For one thread at a time; several files may be read at once.
class DicomPixelReader {
public:
  /// Throws `DataError` for a damaged file.
  explicit DicomPixelReader(const DicomHeader& header);
  /// The same of a file that is loaded.
  DicomPixelReader(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format);
  ~DicomPixelReader();
  DicomPixelReader(const DicomPixelReader&) = delete;
  DicomPixelReader& operator=(const DicomPixelReader&) = delete;

  /// Throws `DataError` naming the file when there are fewer pixels than promised, when they cannot be
  /// unpacked, or are not what the header says.
  DicomPixels read(int frame);

private:
  std::unique_ptr<DicomPixelSource> source_;
};

} // namespace viscera::medical_io
