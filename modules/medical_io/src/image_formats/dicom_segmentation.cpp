#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dicom/dicom_kinds.h"
#include "dicom/dicom_load.h"
#include "dicom/dicom_mark.h"
#include "dicom/dicom_pixels.h"
#include "dicom/dicom_text.h"
#include "dicom/lab_color.h"
#include "dicom/segmentation_grid.h"
#include "image_formats/raw_image.h"
#include "label_segments.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

/// DICOM segmentations (PS3.3, A.51): binary, fractional, and label maps of 2024. DCMTK parses the elements;
/// its module for segmentations (3.6.7) knows no label maps and no packed frames of one bit, and crashes when
/// the functional groups speak of more frames than there are.
namespace viscera::medical_io {
namespace {

constexpr int kMostSegmentNumber = 65535;
/// Empty frames may be left out, but phases of more voxels than this a byte are an error.
constexpr double kMostPhaseVoxelsPerByte = 4096;

[[noreturn]] void failAsOneInstant(const FileBytes& file) {
  file.fail("It is not a file with several phases",
            "name a 4D NIfTI, a .seq.nrrd of 3D Slicer, or one file for each phase");
}

/// What the segments' voxels are.
enum class SegmentCoding { binary, fractional, labelMap };

std::string firstItemText(DcmItem& dataset, DcmItem& item, const DcmTagKey& sequence, const DcmTagKey& key) {
  DcmItem* first = nullptr;
  return item.findAndGetSequenceItem(sequence, first, 0).good() && first != nullptr
             ? textAt(dataset, *first, key)
             : std::string();
}

class SegmentationReader {
public:
  explicit SegmentationReader(const FileBytes& file) : file_(file) {}

  RawImage run() {
    prepare();
    requireOneInstant();
    frames_.resize(header_.frames.size());
    std::iota(frames_.begin(), frames_.end(), std::size_t(0));
    return imageOfFrames();
  }

  /// One image for each temporal position, in their order.
  std::vector<DicomPhase> runPhases(const TakePhase& take) {
    prepare();
    const std::map<double, std::vector<std::size_t>> phases = framesOfPhases();
    std::vector<DicomPhase> times;
    for (const auto& [position, frames] : phases) {
      const DicomFrame& first = header_.frames[frames.front()];
      times.push_back({first.triggerMs, first.intervalMs, std::nullopt});
      frames_ = frames;
      take(times.size() - 1, phases.size(), imageOfFrames());
    }
    return times;
  }

private:
  void prepare() {
    load();
    readSegments();
    grid_ = segmentationGrid(header_, file_);
    pixels_ = std::make_unique<DicomPixelReader>(header_, format_);
  }

  /// The image that `frames_` are slices of.
  RawImage imageOfFrames() {
    raw_ = {};
    raw_.size = grid_.size;
    raw_.indexToLps = grid_.indexToLps;
    raw_.space = "LPS";
    std::vector<LabelLayer> layers;
    if (coding_ == SegmentCoding::labelMap)
      layers.push_back(readLabels());
    else
      layers = readMasks();
    storeLayers(layers, raw_);
    return std::move(raw_);
  }

  std::map<double, std::vector<std::size_t>> framesOfPhases() const {
    std::map<double, std::vector<std::size_t>> phases;
    std::size_t without = 0;
    for (std::size_t f = 0; f < header_.frames.size(); ++f)
      if (const std::optional<double>& position = header_.frames[f].temporalPosition)
        phases[*position].push_back(f);
      else
        ++without;
    if (phases.size() < 2)
      failAsOneInstant(file_);
    if (without > 0)
      file_.fail(diagnostic("a frame has no %1", "temporal position"));
    const double voxels = double(grid_.size[0]) * grid_.size[1] * grid_.size[2];
    const auto bytes = static_cast<double>(std::max<std::uint64_t>(file_.length, file_.bytes.size()));
    if (!(voxels * double(phases.size()) <= kMostPhaseVoxelsPerByte * bytes))
      file_.fail(diagnostic("its frames are too few for %1 phases", phases.size()));
    return phases;
  }

  void load() {
    const std::string known = dicomClass(file_.file);
    if (kindOfDicomClass(known) == DicomKind::other)
      failAsDicomObject(file_, known);
    loadDicom(*format_, file_);
    DcmDataset& dataset = *format_->getDataset();
    const std::string uid = codeAt(dataset, DCM_SOPClassUID);
    if (kindOfDicomClass(uid) == DicomKind::image)
      file_.fail(phrase("It is a DICOM file, but no segmentation (%1)",
                        dcmFindNameOfUID(uid.c_str(), "of an unknown kind")),
                 "open the segmentation that was made from it");
    if (!isSegmentationClass(uid))
      failAsDicomObject(file_, uid);
    const std::string type = codeAt(dataset, DCM_SegmentationType);
    coding_ = type == "LABELMAP"     ? SegmentCoding::labelMap
              : type == "FRACTIONAL" ? SegmentCoding::fractional
                                     : SegmentCoding::binary;
    header_ = dicomHeaderOf(file_.file, *format_);
    if (!header_.notAScan.empty())
      file_.fail(phrase("It is a segmentation that %1", header_.notAScan), "convert it to .seg.nrrd");
    Uint16 largest = 0;
    if (dataset.findAndGetUint16(DCM_MaximumFractionalValue, largest).good() && largest > 0)
      threshold_ = (largest + 1) / 2;
  }

  /// Names and colours by the numbers of segments.
  void readSegments() {
    DcmDataset& dataset = *format_->getDataset();
    DcmSequenceOfItems* sequence = nullptr;
    if (dataset.findAndGetSequence(DCM_SegmentSequence, sequence).bad() || sequence == nullptr)
      file_.fail(diagnostic("its segmentation cannot be read: it describes no segments"));
    DcmObject* at = nullptr;
    while ((at = sequence->nextInContainer(at)) != nullptr) {
      auto* item = dynamic_cast<DcmItem*>(at);
      Uint16 number = 0;
      if (item == nullptr || item->findAndGetUint16(DCM_SegmentNumber, number).bad())
        file_.fail(diagnostic("its segmentation cannot be read: a segment has no number"));
      StatedSegment segment{number, 0, textAt(dataset, *item, DCM_SegmentLabel), recommendedColor(*item)};
      if (segment.name.empty())
        segment.name = firstItemText(dataset, *item, DCM_SegmentedPropertyTypeCodeSequence, DCM_CodeMeaning);
      segments_.emplace(number, std::move(segment));
    }
  }

  /// Phases of a motion must not become one organ that is as large as all of them.
  void requireOneInstant() const {
    std::map<std::pair<int, int>, std::optional<double>> seen; // By segment and slice.
    for (std::size_t f = 0; f < header_.frames.size(); ++f) {
      const DicomFrame& frame = header_.frames[f];
      const auto [at, first] =
          seen.emplace(std::pair(frame.segment, grid_.layers[f]), frame.temporalPosition);
      if (!first && at->second != frame.temporalPosition)
        file_.fail(
            "It is a segmentation over time: its frames show several phases at one place",
            phrase("follow the motion over all of them with viscera track %1, or export a segmentation "
                   "of each phase",
                   file_.file.filename().string()));
    }
  }

  std::string frame(std::size_t number) { return pixels_->read(static_cast<int>(number)).bytes; }

  std::size_t pixelsOfFrame() const { return std::size_t(raw_.size[0]) * std::size_t(raw_.size[1]); }

  /// Calls `take` with the value of each pixel of a frame and the voxel that it is.
  template <class Take>
  void visitFrame(std::size_t number, const Take& take) {
    const std::string bytes = frame(number);
    const std::size_t pixels = pixelsOfFrame(), width = header_.format.allocated == 16 ? 2 : 1;
    if (header_.format.allocated > 16 || bytes.size() < pixels * width)
      file_.fail(diagnostic("its pixels of %1 bits are no segmentation's", header_.format.allocated));
    const std::size_t out = pixels * static_cast<std::size_t>(grid_.layers[number]);
    for (std::size_t p = 0; p < pixels; ++p)
      take(width == 2 ? loadValue<std::uint16_t>(bytes.data() + 2 * p, std::endian::native)
                      : std::uint16_t(static_cast<unsigned char>(bytes[p])),
           out + p);
  }

  /// The numbers of segments are the voxels; what is outside of all has the padding's value, or 0.
  LabelLayer readLabels() {
    const auto voxels = static_cast<std::size_t>(raw_.valueCount());
    const auto& padding = header_.format.padding;
    const std::int64_t background = padding ? (*padding)[0] : 0;
    LabelLayer layer(voxels);
    bool zeroFound = false;
    const int zeroAs = background != 0 && segments_.contains(0) ? freeNumber() : 0;
    for (const std::size_t f : frames_)
      visitFrame(f, [&](std::uint16_t value, std::size_t voxel) {
        if (value == background)
          return;
        zeroFound = zeroFound || value == 0;
        const auto number = value == 0 ? static_cast<std::uint16_t>(zeroAs) : value;
        if (number != 0)
          layer.set(voxel, number);
      });
    for (const auto& [number, segment] : segments_)
      if (number != 0 && number != background)
        raw_.stated.push_back(segment);
    if (zeroFound && zeroAs != 0) {
      StatedSegment zero = segments_.at(0);
      zero.label = zeroAs;
      raw_.stated.push_back(zero);
      raw_.warnings.push_back(phrase("its segment 0 (%1) has got the label %2", zero.name, zeroAs));
    }
    return layer;
  }

  int freeNumber() const {
    int number = 1;
    while (number < kMostSegmentNumber && segments_.contains(number))
      ++number;
    return number;
  }

  /// One mask after the other, in as few layers as their overlaps allow.
  std::vector<LabelLayer> readMasks() {
    std::map<int, std::vector<std::size_t>> frames;
    for (const std::size_t f : frames_)
      frames[segmentOf(f)].push_back(f);
    int least = coding_ == SegmentCoding::fractional ? threshold_ : 1;
    if (least > 1 && isMaskOfOnes()) {
      raw_.warnings.push_back("its fractions are all 0 or 1 of a larger whole; 1 was read as inside");
      least = 1;
    }
    std::vector<LabelLayer> layers;
    for (const auto& [number, list] : frames) {
      LabelLayer mask(static_cast<std::size_t>(raw_.valueCount()));
      for (const std::size_t f : list)
        visitFrame(f, [&](std::uint16_t value, std::size_t voxel) {
          if (value >= least)
            mask.set(voxel, 1);
        });
      StatedSegment segment = segments_.at(number);
      segment.layer = addToFreeLayer(layers, mask, static_cast<std::uint16_t>(number));
      raw_.stated.push_back(std::move(segment));
    }
    return layers;
  }

  int segmentOf(std::size_t f) const {
    const int number = header_.frames[f].segment;
    if (number == 0 && segments_.size() == 1)
      return segments_.begin()->first;
    if (number == 0)
      file_.fail(diagnostic("a frame has no %1", "segment"));
    if (!segments_.contains(number))
      file_.fail(diagnostic("its frames belong to a segment %1, which it does not have", number));
    return number;
  }

  /// Some programs write masks of 0 and 1 as fractions of 255, because only those may be packed. All phases
  /// are alike.
  bool isMaskOfOnes() {
    if (ones_)
      return *ones_;
    std::uint16_t largest = 0;
    for (std::size_t f = 0; f < header_.frames.size() && largest <= 1; ++f)
      visitFrame(f, [&](std::uint16_t value, std::size_t) { largest = std::max(largest, value); });
    ones_ = largest == 1;
    return *ones_;
  }

  const FileBytes& file_;
  std::shared_ptr<DcmFileFormat> format_ = std::make_shared<DcmFileFormat>();
  DicomHeader header_;
  std::unique_ptr<DicomPixelReader> pixels_;
  SegmentationGrid grid_;
  std::vector<std::size_t> frames_; ///< Those that are read.
  RawImage raw_;
  std::optional<bool> ones_; ///< Whether its fractions are masks of ones; none: not known yet.
  SegmentCoding coding_ = SegmentCoding::binary;
  int threshold_ = 128;                   ///< Fractions from here on are inside: one half.
  std::map<int, StatedSegment> segments_; ///< By their numbers.
};

} // namespace

RawImage readDicomSegmentation(FileBytes& file) {
  if (isStructureSetClass(dicomClass(file.file)))
    return readStructureLabels(file);
  return SegmentationReader(file).run();
}

std::vector<DicomPhase> readDicomSegmentations(const FileBytes& file, const TakePhase& take) {
  if (isStructureSetClass(dicomClass(file.file)))
    failAsOneInstant(file);
  return SegmentationReader(file).runPhases(take);
}

} // namespace viscera::medical_io
