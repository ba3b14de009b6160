#include <algorithm>
#include <mutex>
#include <vector>

#include "dicom/dicom_pixel_source.h"
#include "file_bytes.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <gdcmDataElement.h>
#include <gdcmPixmap.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>
#include <gdcmTransferSyntax.h>

/// GDCM parses nothing here: it gets the code stream of one frame.
namespace viscera::medical_io {
namespace {

void silenceGdcm() {
  static std::once_flag once;
  std::call_once(once, [] {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  });
}

std::uint64_t bytesOf(const DicomHeader& header) {
  return std::uint64_t(header.rows) * std::uint64_t(header.columns) *
         std::uint64_t(header.format.allocated / 8);
}

/// Packed pixels: fragments, of which a frame has one or more.
class Jpeg2000Source final : public DicomPixelSource {
public:
  Jpeg2000Source(const DicomHeader& header, std::shared_ptr<DcmFileFormat> format)
      : header_(header), file_{header.file, {}}, format_(std::move(format)) {
    silenceGdcm();
    DcmDataset& dataset = *format_->getDataset();
    syntax_ = gdcm::TransferSyntax::GetTSType(DcmXfer(dataset.getOriginalXfer()).getXferID());
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
      file_.fail("its pixels cannot be read");
    auto* pixels = dynamic_cast<DcmPixelData*>(element);
    if (pixels == nullptr ||
        pixels->getEncapsulatedRepresentation(dataset.getOriginalXfer(), nullptr, fragments_).bad() ||
        fragments_ == nullptr || fragments_->card() < 2)
      file_.fail("its header is damaged: its packed pixels have no parts");
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
      file_.fail("its header is damaged: " + counted(parts, "part", "parts") + " for " +
                 counted(frames, "frame", "frames"));
  }

  /// Where each part begins, counted as the table counts: from the first part's own header on.
  std::vector<std::uint64_t> partOffsets() {
    std::vector<std::uint64_t> offsets;
    std::uint64_t at = 0;
    for (unsigned long part = 1; part < fragments_->card(); ++part) {
      DcmPixelItem* item = nullptr;
      if (fragments_->getItem(item, part).bad() || item == nullptr)
        file_.fail("its packed pixels cannot be read");
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
      file_.fail("its packed pixels cannot be read");
    const std::size_t size = item->getLength();
    if (size == 0)
      return {};
    if (item->getUint8Array(bytes).bad() || bytes == nullptr)
      file_.fail("its packed pixels cannot be read");
    return {reinterpret_cast<const char*>(bytes), size};
  }

  std::string packedFrame(std::size_t frame) {
    std::string packed;
    for (std::size_t part = firstPart_[frame]; part < firstPart_[frame + 1]; ++part)
      packed += fragment(part + 1);
    if (packed.empty())
      file_.fail("frame " + std::to_string(frame + 1) + " has no pixels");
    return packed;
  }

  DicomPixels unpack(const std::string& packed) const {
    const DicomPixelFormat& stated = header_.format;
    gdcm::Fragment fragment;
    fragment.SetByteValue(packed.data(), static_cast<std::uint32_t>(packed.size()));
    gdcm::SmartPointer<gdcm::SequenceOfFragments> sequence = new gdcm::SequenceOfFragments;
    sequence->AddFragment(fragment);
    gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010), 0, gdcm::VR::OB);
    element.SetValue(*sequence);
    gdcm::Pixmap picture;
    picture.SetNumberOfDimensions(2);
    picture.SetDimension(0, static_cast<unsigned>(header_.columns));
    picture.SetDimension(1, static_cast<unsigned>(header_.rows));
    picture.SetPixelFormat(gdcm::PixelFormat(1, static_cast<unsigned short>(stated.allocated),
                                             static_cast<unsigned short>(stated.stored),
                                             static_cast<unsigned short>(stated.high), stated.isSigned));
    picture.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
    picture.SetTransferSyntax(gdcm::TransferSyntax(syntax_));
    picture.SetDataElement(element);
    const std::size_t promised = picture.GetBufferLength();
    // A codec may find wider pixels in the packed data than the header says.
    std::string bytes(4 * promised, '\0');
    bool done = false;
    try {
      done = promised == bytesOf(header_) && picture.GetBuffer(bytes.data());
    } catch (const std::exception&) {
      done = false;
    }
    const gdcm::PixelFormat& found = picture.GetPixelFormat();
    if (!done || found.GetBitsAllocated() != stated.allocated || found.GetSamplesPerPixel() != 1 ||
        picture.GetBufferLength() != promised)
      file_.fail("its pixels (" + header_.transferSyntax + ") are damaged or packed in an unknown way");
    bytes.resize(promised);
    DicomPixels pixels{std::move(bytes), stated};
    pixels.format.stored = found.GetBitsStored();
    pixels.format.high = found.GetHighBit();
    pixels.format.isSigned = found.GetPixelRepresentation() == 1;
    return pixels;
  }

  const DicomHeader& header_;
  FileBytes file_;
  std::shared_ptr<DcmFileFormat> format_; ///< Owns the fragments.
  DcmPixelSequence* fragments_ = nullptr;
  std::vector<std::size_t> firstPart_; ///< Of each frame, and one behind the last.
  gdcm::TransferSyntax::TSType syntax_ = gdcm::TransferSyntax::TS_END;
};

} // namespace

std::unique_ptr<DicomPixelSource> jpeg2000Pixels(const DicomHeader& header,
                                                 std::shared_ptr<DcmFileFormat> format) {
  return std::make_unique<Jpeg2000Source>(header, std::move(format));
}

} // namespace viscera::medical_io
