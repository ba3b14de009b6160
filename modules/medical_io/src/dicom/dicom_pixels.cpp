#include "dicom/dicom_pixels.h"

#include <algorithm>
#include <bit>
#include <mutex>
#include <string_view>

#include "dicom/dicom_load.h"
#include "dicom/dicom_pixel_source.h"
#include "file_bytes.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

/// DCMTK parses, because it holds every length against the file, and unpacks JPEG and JPEG-LS, because it
/// does so without printing. JPEG 2000, which it does not know, goes to OpenJPEG; RLE, where it reads behind
/// damaged data, is ours.
namespace viscera::medical_io {
namespace {

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
      file_.fail(diagnostic("its pixels cannot be read"));
    }
    if (header.format.allocated == 32 && dataset.getOriginalXfer() == EXS_BigEndianExplicit)
      file_.fail(diagnostic("its pixels of 32 bits in big-endian order are not supported"),
                 "export it little-endian");
  }

  DicomPixels read(int frame) override {
    if (header_.format.allocated == 1)
      return readBits(frame);
    const std::uint64_t each = bytesOf(header_);
    const std::uint64_t begin = saturatedProduct(each, static_cast<std::uint64_t>(frame));
    if (saturatedSum(begin, each) > size_)
      file_.fail(diagnostic("the file is cut off: its header promises %1 bytes of pixels, %2 are there",
                            each * header_.frames.size(), size_));
    return {std::string(pixels_ + begin, each), header_.format};
  }

private:
  /// Frames of bits follow each other without a gap.
  DicomPixels readBits(int frame) const {
    const std::uint64_t each = std::uint64_t(header_.rows) * std::uint64_t(header_.columns);
    const std::uint64_t first = each * static_cast<std::uint64_t>(frame);
    if ((first + each + 7) / 8 > size_)
      file_.fail(diagnostic("the file is cut off: its %n {frame has|frames have} too few pixels",
                            header_.frames.size()));
    return {bytesOfBits({pixels_, size_}, first, each), header_.format};
  }

  const DicomHeader& header_;
  FileBytes file_;
  std::shared_ptr<DcmFileFormat> format_; ///< Owns the pixels.
  const char* pixels_ = nullptr;
  std::uint64_t size_ = 0;
};

static_assert(std::endian::native == std::endian::little, "widened pixels begin with their lowest byte");

bool isJpeg(E_TransferSyntax syntax) {
  return syntax >= EXS_JPEGProcess1 && syntax <= EXS_JPEGProcess14SV1;
}

/// Bits of a pixel by the frame header of a JPEG stream (ISO/IEC 10918-1, B.2.2); 0 where there is none
/// behind its first marker and segments that have a length.
int jpegPrecision(std::string_view stream) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(stream[at]); };
  if (!stream.starts_with("\xFF\xD8"))
    return 0;
  std::size_t at = 2;
  while (at + 5 <= stream.size() && byte(at) == 0xFF) {
    const int marker = byte(at + 1);
    const bool isTable = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
    const bool hasLength = marker >= 0xC0 && (marker < 0xD0 || marker > 0xD9);
    if (marker >= 0xC0 && marker <= 0xCF && !isTable)
      return byte(at + 4);
    if (marker == 0xDA || !hasLength)
      return 0;
    at += marker == 0xFF ? 1 : 2 + std::size_t(byte(at + 2)) * 256 + byte(at + 3);
  }
  return 0;
}

/// The same pixels, with zeros above their bytes.
std::string widened(const std::string& bytes, std::size_t pixels, std::size_t from, std::size_t to) {
  std::string wide(pixels * to, '\0');
  for (std::size_t p = 0; p < pixels; ++p)
    std::copy_n(bytes.data() + p * from, from, wide.data() + p * to);
  return wide;
}

/// Pixels that one of DCMTK's codecs unpacks.
class PackedSource final : public DicomPixelSource {
public:
  PackedSource(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
      : header_(header), file_{header.file, {}}, format_(std::move(format)) {
    registerCodecs();
    if (header.format.allocated == 1)
      file_.fail(phrase("its pixels of one bit are packed in a way that is not supported (%1)",
                        header.transferSyntax),
                 "save it without compression");
    DcmElement* element = nullptr;
    if (format_->getDataset()->findAndGetElement(DCM_PixelData, element).good())
      pixels_ = dynamic_cast<DcmPixelData*>(element);
    if (pixels_ == nullptr)
      file_.fail(diagnostic("its pixels cannot be read"));
  }

  DicomPixels read(int frame) override {
    const std::uint64_t each = bytesOf(header_);
    std::string bytes(each + each % 2, '\0'); // DCMTK wants an even number.
    OFString colours;
    Uint32 part = frame == nextFrame_ ? nextPart_ : 0;
    const std::size_t unpacked = unpackedBytes(frame, part);
    const OFCondition done =
        pixels_->getUncompressedFrame(format_->getDataset(), static_cast<Uint32>(frame), part, bytes.data(),
                                      static_cast<Uint32>(bytes.size()), colours);
    if (done.bad())
      file_.fail(diagnostic("its pixels (%1) cannot be unpacked: %2", header_.transferSyntax, done.text()));
    nextFrame_ = frame + 1;
    nextPart_ = part;
    bytes.resize(each);
    const auto allocated = static_cast<std::size_t>(header_.format.allocated / 8);
    if (unpacked < allocated)
      bytes = widened(bytes, each / allocated, unpacked, allocated);
    return {std::move(bytes), header_.format};
  }

private:
  /// Bytes of a pixel: DCMTK makes bytes of JPEG streams of 8 bits and words of others, whatever the header
  /// says.
  std::size_t unpackedBytes(int frame, Uint32 part) {
    const auto allocated = static_cast<std::size_t>(header_.format.allocated / 8);
    DcmDataset& dataset = *format_->getDataset();
    DcmPixelSequence* parts = nullptr;
    DcmPixelItem* item = nullptr;
    Uint8* stream = nullptr;
    if (pixels_->getEncapsulatedRepresentation(dataset.getOriginalXfer(), nullptr, parts).bad() ||
        parts == nullptr)
      return allocated;
    if (part == 0 && DcmCodec::determineStartFragment(static_cast<Uint32>(frame),
                                                      static_cast<Sint32>(header_.frames.size()), parts, part)
                         .bad())
      return allocated;
    if (parts->getItem(item, part).bad() || item == nullptr || item->getUint8Array(stream).bad() ||
        stream == nullptr)
      return allocated;
    const int precision = jpegPrecision({reinterpret_cast<const char*>(stream), item->getLength()});
    // DCMTK 3.6.7 looks for that header, too, and stays for ever at a marker without a length (TEM, FF 01).
    if (precision == 0 && isJpeg(dataset.getOriginalXfer()))
      file_.fail(diagnostic("its JPEG stream is damaged: it has no frame header"));
    return precision == 0 ? allocated : precision <= 8 ? 1 : 2;
  }

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

std::string bytesOfBits(std::string_view bits, std::uint64_t first, std::uint64_t count) {
  std::string bytes(count, '\0');
  for (std::uint64_t p = 0; p < count; ++p)
    bytes[p] = static_cast<char>(static_cast<unsigned char>(bits[(first + p) / 8]) >> ((first + p) % 8) & 1);
  return bytes;
}

DicomPixelReader::DicomPixelReader(const DicomHeader& header) {
  const auto format = std::make_shared<DcmFileFormat>();
  loadDicom(*format, FileBytes{header.file, {}});
  source_ = sourceOf(header, format);
}

DicomPixelReader::DicomPixelReader(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
    : source_(sourceOf(header, std::move(format))) {}

DicomPixelReader::~DicomPixelReader() = default;

DicomPixels DicomPixelReader::read(int frame) {
  return source_->read(frame);
}

} // namespace viscera::medical_io
