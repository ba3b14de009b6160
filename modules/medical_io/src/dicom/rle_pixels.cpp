#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>
#include <string_view>

#include "dicom/dicom_pixel_source.h"
#include "file_bytes.h"
#include "scalar.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

/// RLE (DICOM PS3.5, annex G): each byte of the pixels, the most significant first, is a segment that is
/// packed as PackBits. DCMTK's own decoder reads behind the end of damaged segments.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kRleHeaderBytes = 64;
constexpr std::size_t kMostRleSegments = 15;

/// Unpacks one segment into every `step`-th byte from `out` on; false when it ends too early or holds too
/// much.
bool unpackSegment(std::string_view packed, std::size_t count, std::size_t step, char* out) {
  std::size_t at = 0, done = 0;
  while (done < count) {
    if (at >= packed.size())
      return false;
    const int code = static_cast<signed char>(packed[at++]);
    if (code == -128)
      continue;
    const std::size_t run = static_cast<std::size_t>(code >= 0 ? code + 1 : 1 - code);
    const std::size_t read = code >= 0 ? run : 1;
    if (run > count - done || read > packed.size() - at)
      return false;
    for (std::size_t i = 0; i < run; ++i)
      out[(done + i) * step] = packed[at + (code >= 0 ? i : 0)];
    at += read;
    done += run;
  }
  return true;
}

/// Pixels of one bit: eight of them a byte, each frame from a byte of its own on; or, as some programs write
/// them, a byte for each.
std::optional<std::string> unpackBits(std::string_view packed, std::size_t pixels) {
  std::string bytes(pixels, '\0');
  if (unpackSegment(packed, pixels, 1, bytes.data()))
    return bytes;
  const std::size_t whole = (pixels + 7) / 8;
  bytes.assign(whole, '\0');
  if (!unpackSegment(packed, whole, 1, bytes.data()))
    return std::nullopt;
  return bytesOfBits(bytes, 0, pixels);
}

class RleSource final : public DicomPixelSource {
public:
  RleSource(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
      : header_(header), file_{header.file, {}}, format_(std::move(format)) {
    DcmElement* element = nullptr;
    if (format_->getDataset()->findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
      file_.fail(diagnostic("its pixels cannot be read"));
    auto* pixels = dynamic_cast<DcmPixelData*>(element);
    if (pixels == nullptr ||
        pixels->getEncapsulatedRepresentation(EXS_RLELossless, nullptr, fragments_).bad() ||
        fragments_ == nullptr || fragments_->card() != header.frames.size() + 1)
      file_.fail(diagnostic("its header is damaged: its packed pixels have not one part a frame"));
  }

  DicomPixels read(int frame) override {
    DcmPixelItem* item = nullptr;
    Uint8* bytes = nullptr;
    // The item before the first is a table of where frames begin.
    if (fragments_->getItem(item, static_cast<unsigned long>(frame) + 1).bad() || item == nullptr ||
        item->getUint8Array(bytes).bad() || bytes == nullptr)
      file_.fail(diagnostic("its packed pixels cannot be read"));
    return {unpack({reinterpret_cast<const char*>(bytes), item->getLength()}, frame), header_.format};
  }

private:
  std::string unpack(std::string_view packed, int frame) const {
    const auto pixels = static_cast<std::size_t>(header_.rows) * static_cast<std::size_t>(header_.columns);
    const bool bits = header_.format.allocated == 1;
    const auto depth = bits ? 1 : static_cast<std::size_t>(header_.format.allocated / 8);
    const auto damaged = [&] {
      file_.fail(diagnostic("its pixels (%1) cannot be unpacked: frame %2 is damaged", header_.transferSyntax,
                            frame + 1));
    };
    std::string bytes;
    if (packed.size() < kRleHeaderBytes || depth > kMostRleSegments ||
        loadValue<std::uint32_t>(packed.data(), std::endian::little) != depth)
      damaged();
    bytes.resize(pixels * depth);
    for (std::size_t segment = 0; segment < depth; ++segment) {
      const auto offset = [&](std::size_t i) -> std::size_t {
        return i < depth ? loadValue<std::uint32_t>(packed.data() + 4 * (i + 1), std::endian::little)
                         : packed.size();
      };
      const std::size_t begin = offset(segment), end = offset(segment + 1);
      if (begin < kRleHeaderBytes || end < begin || end > packed.size())
        damaged();
      if (bits) {
        std::optional<std::string> unpacked = unpackBits(packed.substr(begin, end - begin), pixels);
        if (!unpacked)
          damaged();
        return *std::move(unpacked);
      }
      const std::size_t place = std::endian::native == std::endian::little ? depth - 1 - segment : segment;
      if (!unpackSegment(packed.substr(begin, end - begin), pixels, depth, bytes.data() + place))
        damaged();
    }
    return bytes;
  }

  const DicomHeader& header_;
  FileBytes file_;
  std::shared_ptr<DcmFileFormat> format_; ///< Owns the fragments.
  DcmPixelSequence* fragments_ = nullptr;
};

} // namespace

std::unique_ptr<DicomPixelSource> rlePixels(const DicomHeader& header,
                                            std::shared_ptr<DcmFileFormat> format) {
  return std::make_unique<RleSource>(header, std::move(format));
}

} // namespace viscera::medical_io
