#include "dicom/dicom_pixels.h"

#include <mutex>

#include "dicom/dicom_pixel_source.h"
#include "dicom/quiet_dcmtk.h"
#include "file_bytes.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

/// DCMTK parses, because it holds every length against the file, and unpacks JPEG and JPEG-LS, because it
/// does so without printing. JPEG 2000, which it does not know, goes to OpenJPEG; RLE, where it reads behind
/// damaged data, is ours.
namespace viscera::medical_io {
namespace {

/// Bytes of a value; longer ones stay on the disk until they are read.
constexpr Uint32 kLongestLoadedPixels = 4096;

void registerCodecs() {
  static std::once_flag once;
  std::call_once(once, [] {
    DJDecoderRegistration::registerCodecs();
    DJLSDecoderRegistration::registerCodecs();
  });
}

std::uint64_t bytesOf(const DicomHeader& header) {
  return std::uint64_t(header.rows) * std::uint64_t(header.columns) *
         std::uint64_t(header.format.allocated / 8);
}

/// Pixels that are not packed, all frames behind each other.
class PlainSource final : public DicomPixelSource {
public:
  PlainSource(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
      : header_(header), file_{header.file, {}}, format_(std::move(format)) {
    DcmDataset& dataset = *format_->getDataset();
    const Uint8* bytes = nullptr;
    const Uint16* words = nullptr;
    unsigned long count = 0;
    // Whether pixels are bytes or words is the element's type, not the pixels' width.
    if (dataset.findAndGetUint16Array(DCM_PixelData, words, &count).good() && words != nullptr) {
      pixels_ = reinterpret_cast<const char*>(words);
      size_ = std::uint64_t{count} * sizeof(Uint16);
    } else if (dataset.findAndGetUint8Array(DCM_PixelData, bytes, &count).good() && bytes != nullptr) {
      pixels_ = reinterpret_cast<const char*>(bytes);
      size_ = count;
    } else {
      file_.fail("its pixels cannot be read");
    }
    if (header.format.allocated == 32 && dataset.getOriginalXfer() == EXS_BigEndianExplicit)
      file_.fail("its pixels of 32 bits in big-endian order are not supported", "export it little-endian");
  }

  DicomPixels read(int frame) override {
    const std::uint64_t each = bytesOf(header_);
    const std::uint64_t begin = saturatedProduct(each, static_cast<std::uint64_t>(frame));
    if (saturatedSum(begin, each) > size_)
      file_.fail(phrase("the file is cut off: its header promises %1 bytes of pixels, %2 are there",
                        each * header_.frames.size(), size_));
    return {std::string(pixels_ + begin, each), header_.format};
  }

private:
  const DicomHeader& header_;
  FileBytes file_;
  std::shared_ptr<DcmFileFormat> format_; ///< Owns the pixels.
  const char* pixels_ = nullptr;
  std::uint64_t size_ = 0;
};

/// Pixels that one of DCMTK's codecs unpacks.
class PackedSource final : public DicomPixelSource {
public:
  PackedSource(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
      : header_(header), file_{header.file, {}}, format_(std::move(format)) {
    registerCodecs();
    DcmElement* element = nullptr;
    if (format_->getDataset()->findAndGetElement(DCM_PixelData, element).good())
      pixels_ = dynamic_cast<DcmPixelData*>(element);
    if (pixels_ == nullptr)
      file_.fail("its pixels cannot be read");
  }

  DicomPixels read(int frame) override {
    const std::uint64_t each = bytesOf(header_);
    std::string bytes(each + each % 2, '\0'); // DCMTK wants an even number.
    OFString colours;
    Uint32 part = frame == nextFrame_ ? nextPart_ : 0;
    const OFCondition done =
        pixels_->getUncompressedFrame(format_->getDataset(), static_cast<Uint32>(frame), part, bytes.data(),
                                      static_cast<Uint32>(bytes.size()), colours);
    if (done.bad())
      file_.fail(phrase("its pixels (%1) cannot be unpacked: %2", header_.transferSyntax, done.text()));
    nextFrame_ = frame + 1;
    nextPart_ = part;
    bytes.resize(each);
    return {std::move(bytes), header_.format};
  }

private:
  const DicomHeader& header_;
  FileBytes file_;
  std::shared_ptr<DcmFileFormat> format_; ///< Owns the pixels.
  DcmPixelData* pixels_ = nullptr;
  int nextFrame_ = 0; ///< That begins at `nextPart_`.
  Uint32 nextPart_ = 0;
};

std::unique_ptr<DicomPixelSource> sourceOf(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format) {
  if (!header.packed)
    return std::make_unique<PlainSource>(header, std::move(format));
  switch (format->getDataset()->getOriginalXfer()) {
  case EXS_JPEG2000LosslessOnly:
  case EXS_JPEG2000:
    return jpeg2000Pixels(header, std::move(format));
  case EXS_RLELossless:
    return rlePixels(header, std::move(format));
  default:
    return std::make_unique<PackedSource>(header, std::move(format));
  }
}

} // namespace

DicomPixelReader::DicomPixelReader(const DicomHeader& header) {
  silenceDcmtk();
  const auto format = std::make_shared<DcmFileFormat>();
  const OFCondition loaded =
      format->loadFile(header.file.c_str(), EXS_Unknown, EGL_noChange, kLongestLoadedPixels, ERM_autoDetect);
  if (loaded.bad())
    FileBytes{header.file, {}}.fail(phrase("It is damaged or no DICOM file: %1", loaded.text()));
  source_ = sourceOf(header, format);
}

DicomPixelReader::~DicomPixelReader() = default;

DicomPixels DicomPixelReader::read(int frame) {
  return source_->read(frame);
}

} // namespace viscera::medical_io
