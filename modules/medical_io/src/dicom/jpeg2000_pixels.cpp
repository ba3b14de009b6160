#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>
#include <vector>

#include "dicom/dicom_pixel_source.h"
#include "file_bytes.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <openjpeg.h>

/// OpenJPEG gets the code stream of one frame. What its header promises is held against the file's before
/// memory is taken. GDCM, which wraps OpenJPEG, writes behind its buffer when the two differ.
namespace viscera::medical_io {
namespace {

/// Bytes as OpenJPEG reads them.
struct PackedStream {
  std::string_view bytes;
  std::size_t at = 0;

  static OPJ_SIZE_T read(void* out, OPJ_SIZE_T count, void* self) {
    auto& s = *static_cast<PackedStream*>(self);
    const std::size_t copied = s.bytes.substr(s.at).copy(static_cast<char*>(out), count);
    s.at += copied;
    return copied > 0 ? copied : static_cast<OPJ_SIZE_T>(-1);
  }
  static OPJ_OFF_T skip(OPJ_OFF_T count, void* self) {
    auto& s = *static_cast<PackedStream*>(self);
    const auto there = static_cast<OPJ_OFF_T>(s.bytes.size() - s.at);
    if (count < 0 || there == 0)
      return -1;
    const OPJ_OFF_T skipped = std::min(count, there);
    s.at += static_cast<std::size_t>(skipped);
    return skipped;
  }
  static OPJ_BOOL seek(OPJ_OFF_T to, void* self) {
    auto& s = *static_cast<PackedStream*>(self);
    if (to < 0 || static_cast<std::size_t>(to) > s.bytes.size())
      return OPJ_FALSE;
    s.at = static_cast<std::size_t>(to);
    return OPJ_TRUE;
  }
};

using Codec = std::unique_ptr<opj_codec_t, void (*)(opj_codec_t*)>;
using Stream = std::unique_ptr<opj_stream_t, void (*)(opj_stream_t*)>;
using Image = std::unique_ptr<opj_image_t, void (*)(opj_image_t*)>;

Codec codecFor(std::string_view packed) {
  // Some writers put the file format JP2 around the code stream that belongs there.
  constexpr std::string_view kBox("\0\0\0\x0CjP  ", 8);
  Codec codec(opj_create_decompress(packed.starts_with(kBox) ? OPJ_CODEC_JP2 : OPJ_CODEC_J2K),
              opj_destroy_codec);
  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  opj_setup_decoder(codec.get(), &parameters);
  return codec;
}

Stream streamOf(PackedStream& source) {
  Stream stream(opj_stream_create(1 << 16, OPJ_TRUE), opj_stream_destroy);
  opj_stream_set_user_data(stream.get(), &source, nullptr);
  opj_stream_set_user_data_length(stream.get(), source.bytes.size());
  opj_stream_set_read_function(stream.get(), PackedStream::read);
  opj_stream_set_skip_function(stream.get(), PackedStream::skip);
  opj_stream_set_seek_function(stream.get(), PackedStream::seek);
  return stream;
}

/// Whether a code stream is the picture that the file's header describes.
bool isThePicture(const opj_image_t& image, const DicomHeader& header) {
  if (image.numcomps != 1)
    return false;
  const opj_image_comp_t& pixels = image.comps[0];
  return pixels.dx == 1 && pixels.dy == 1 && pixels.w == OPJ_UINT32(header.columns) &&
         pixels.h == OPJ_UINT32(header.rows) && pixels.prec >= 1 &&
         pixels.prec <= OPJ_UINT32(header.format.allocated);
}

/// A picture of more than 2^26 pixels has a byte for a thousand of them, or else is a damaged header.
bool isPlausible(std::size_t packedBytes, const DicomHeader& header) {
  const std::uint64_t pixels = std::uint64_t(header.rows) * std::uint64_t(header.columns);
  return pixels <= (1U << 26U) || pixels / 1000 <= packedBytes;
}

/// A tile has a header of 14 bytes at least. OpenJPEG takes some 10 kB for each tile that the size segment of
/// a code stream (ISO/IEC 15444-1, A.5.1) promises, before it has seen one.
bool hasRoomForItsTiles(std::string_view packed) {
  constexpr std::string_view kSize("\xFF\x4F\xFF\x51");
  constexpr std::size_t kExtent = 8, kTile = 24, kLength = 40, kLeastTile = 14;
  for (std::size_t at = packed.find(kSize); at != packed.npos; at = packed.find(kSize, at + 1)) {
    if (at + kLength > packed.size())
      return false;
    std::uint64_t tiles = 1;
    for (const std::size_t axis : {0U, 4U}) {
      const auto number = [&](std::size_t offset) -> std::uint64_t {
        return loadValue<std::uint32_t>(packed.data() + at + offset + axis, std::endian::big);
      };
      const std::uint64_t extent = number(kExtent), origin = number(kTile + 8), size = number(kTile);
      if (size == 0 || origin > extent)
        return false;
      tiles *= (extent - origin + size - 1) / size;
    }
    if (tiles > packed.size() / kLeastTile)
      return false;
  }
  return true;
}

/// The picture in a code stream; none when it is damaged or another one than the header describes.
Image unpacked(std::string_view packed, const DicomHeader& header) {
  Image none(nullptr, opj_image_destroy);
  if (!isPlausible(packed.size(), header) || !hasRoomForItsTiles(packed))
    return none;
  PackedStream source{packed};
  const Codec codec = codecFor(packed);
  const Stream stream = streamOf(source);
  opj_image_t* made = nullptr;
  const bool known = opj_read_header(stream.get(), codec.get(), &made) != OPJ_FALSE;
  Image image(made, opj_image_destroy);
  if (!known || image == nullptr || !isThePicture(*image, header) ||
      opj_decode(codec.get(), stream.get(), image.get()) == OPJ_FALSE || !isThePicture(*image, header) ||
      image->comps[0].data == nullptr)
    return none;
  return image;
}

template <typename Pixel>
std::string bytesAs(const opj_image_comp_t& picture) {
  const std::size_t count = std::size_t(picture.w) * picture.h;
  std::string bytes(count * sizeof(Pixel), '\0');
  for (std::size_t p = 0; p < count; ++p) {
    const auto pixel = static_cast<Pixel>(picture.data[p]);
    std::memcpy(bytes.data() + p * sizeof(Pixel), &pixel, sizeof(Pixel));
  }
  return bytes;
}

std::string bytesOf(const opj_image_comp_t& picture, int bitsAllocated) {
  if (bitsAllocated <= 8)
    return bytesAs<std::uint8_t>(picture);
  return bitsAllocated == 16 ? bytesAs<std::uint16_t>(picture) : bytesAs<std::uint32_t>(picture);
}

/// Packed pixels: fragments, of which a frame has one or more.
class Jpeg2000Source final : public DicomPixelSource {
public:
  Jpeg2000Source(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
      : header_(header), file_{header.file, {}}, format_(std::move(format)) {
    DcmDataset& dataset = *format_->getDataset();
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
      file_.fail(diagnostic("its pixels cannot be read"));
    auto* pixels = dynamic_cast<DcmPixelData*>(element);
    if (pixels == nullptr ||
        pixels->getEncapsulatedRepresentation(dataset.getOriginalXfer(), nullptr, fragments_).bad() ||
        fragments_ == nullptr || fragments_->card() < 2)
      file_.fail(diagnostic("its header is damaged: its packed pixels have no parts"));
    assignFragments();
  }

  DicomPixels read(int frame) override {
    const std::string packed = packedFrame(static_cast<std::size_t>(frame));
    return unpack(packed);
  }

private:
  /// The first item holds where each frame begins, or nothing.
  void assignFragments() {
    const std::size_t frames = header_.frames.size(), parts = fragments_->card() - 1;
    if (parts == frames) {
      for (std::size_t f = 0; f <= frames; ++f)
        firstPart_.push_back(f);
      return;
    }
    firstPart_.push_back(0);
    if (frames > 1)
      addFirstParts(partOffsets());
    firstPart_.push_back(parts);
    if (firstPart_.size() != frames + 1)
      file_.fail(diagnostic("its header is damaged: its packed pixels have %n {part|parts} for %2 frames",
                            parts, frames));
  }

  /// Where each part begins, counted as the table counts: from the first part's own header on.
  std::vector<std::uint64_t> partOffsets() {
    std::vector<std::uint64_t> offsets;
    std::uint64_t at = 0;
    for (unsigned long part = 1; part < fragments_->card(); ++part) {
      DcmPixelItem* item = nullptr;
      if (fragments_->getItem(item, part).bad() || item == nullptr)
        file_.fail(diagnostic("its packed pixels cannot be read"));
      offsets.push_back(at);
      at += 8 + item->getLength();
    }
    return offsets;
  }

  void addFirstParts(const std::vector<std::uint64_t>& offsets) {
    const std::string table = fragment(0);
    for (std::size_t f = 1; f < header_.frames.size() && 4 * f + 4 <= table.size(); ++f) {
      const std::uint64_t begin = loadValue<std::uint32_t>(table.data() + 4 * f, std::endian::little);
      const auto part = std::lower_bound(offsets.begin(), offsets.end(), begin);
      if (part == offsets.end() || *part != begin ||
          static_cast<std::size_t>(part - offsets.begin()) <= firstPart_.back())
        return;
      firstPart_.push_back(static_cast<std::size_t>(part - offsets.begin()));
    }
  }

  /// Number 0 is the table.
  std::string fragment(std::size_t number) {
    DcmPixelItem* item = nullptr;
    Uint8* bytes = nullptr;
    if (fragments_->getItem(item, static_cast<unsigned long>(number)).bad() || item == nullptr)
      file_.fail(diagnostic("its packed pixels cannot be read"));
    const std::size_t size = item->getLength();
    if (size == 0)
      return {};
    if (item->getUint8Array(bytes).bad() || bytes == nullptr)
      file_.fail(diagnostic("its packed pixels cannot be read"));
    return {reinterpret_cast<const char*>(bytes), size};
  }

  std::string packedFrame(std::size_t frame) {
    std::string packed;
    for (std::size_t part = firstPart_[frame]; part < firstPart_[frame + 1]; ++part)
      packed += fragment(part + 1);
    if (packed.empty())
      file_.fail(diagnostic("frame %1 has no pixels", frame + 1));
    return packed;
  }

  DicomPixels unpack(const std::string& packed) const {
    const Image image = unpacked(packed, header_);
    if (image == nullptr)
      file_.fail(
          diagnostic("its pixels (%1) are damaged or packed in an unknown way", header_.transferSyntax));
    const opj_image_comp_t& found = image->comps[0];
    DicomPixels pixels{bytesOf(found, header_.format.allocated), header_.format};
    pixels.format.stored = static_cast<int>(found.prec);
    pixels.format.high = pixels.format.stored - 1;
    pixels.format.isSigned = found.sgnd != 0;
    return pixels;
  }

  const DicomHeader& header_;
  FileBytes file_;
  std::shared_ptr<DcmFileFormat> format_; ///< Owns the fragments.
  DcmPixelSequence* fragments_ = nullptr;
  std::vector<std::size_t> firstPart_; ///< Of each frame, and one behind the last.
};

} // namespace

std::unique_ptr<DicomPixelSource> jpeg2000Pixels(const DicomHeader& header,
                                                 std::shared_ptr<DcmFileFormat> format) {
  return std::make_unique<Jpeg2000Source>(header, std::move(format));
}

} // namespace viscera::medical_io
