#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "dicom/deflated_dicom.h"
#include "dicom/dicom_header.h"
#include "dicom/quiet_dcmtk.h"
#include "image_formats/raw_image.h"
#include "label_segments.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmfg/fgseg.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

/// DICOM segmentations (PS3.3, A.51), binary and fractional, parsed by DCMTK.
namespace viscera::medical_io {
namespace {

/// Slices whose distance is this much of the spacing off a whole number are no stack.
constexpr double kSliceTolerance = 0.05;
/// Frames without voxels may be left out of the file, but a volume of more voxels than this a byte is an
/// error in a position, not a patient.
constexpr double kMostVoxelsPerByte = 4096;
constexpr double kSameFrameDirection = 1e-4;

constexpr double kLargestLab = 65535;

/// CIE 15: the inverse of the cube root with a straight beginning.
double fromLab(double t) {
  constexpr double kJoint = 6.0 / 29;
  return t > kJoint ? t * t * t : 3 * kJoint * kJoint * (t - 4.0 / 29);
}

double gammaOfSrgb(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// The colour, 0 to 1 in sRGB, of a CIELab value as DICOM stores it (PS3.3, C.10.7.1.1: each of the three
/// over its whole range in 16 bits, under the illuminant D50). Colours that a screen cannot show are clipped.
Vec3 colorOfDicomLab(std::uint16_t l, std::uint16_t a, std::uint16_t b) {
  const double lightness = (100.0 * l / kLargestLab + 16) / 116;
  const double x = fromLab(lightness + (255.0 * a / kLargestLab - 128) / 500);
  const double z = fromLab(lightness - (255.0 * b / kLargestLab - 128) / 200);
  const Vec3 xyz = Vec3(0.96422 * x, fromLab(lightness), 0.82521 * z); // The white of D50.
  Eigen::Matrix3d toLinear; // D50, adapted to the white of sRGB after Bradford.
  toLinear << 3.1338561, -1.6168667, -0.4906146, -0.9787684, 1.9161415, 0.0334540, 0.0719453, -0.2289914,
      1.4052427;
  return (toLinear * xyz).unaryExpr(&gammaOfSrgb);
}

/// One frame: a slice of one segment.
struct Slice {
  std::size_t frame = 0;
  int segment = 0;
  Vec3 position = Vec3::Zero();
};

class SegmentationReader {
public:
  explicit SegmentationReader(const FileBytes& file) : file_(file) {}

  RawImage run() {
    load();
    readSize();
    readSlices();
    placeGrid();
    paintSlices();
    raw_.space = "LPS";
    return std::move(raw_);
  }

private:
  void require(const OFCondition& condition, const Text& what) const {
    if (condition.bad())
      file_.fail(diagnostic("%1: %2", what, condition.text()));
  }

  void load() {
    silenceDcmtk();
    requireBoundedInflation(file_.name());
    require(format_.loadFile(file_.name().c_str()), diagnostic("It is damaged or no DICOM file"));
    DcmDataset& dataset = *format_.getDataset();
    OFString uid;
    dataset.findAndGetOFString(DCM_SOPClassUID, uid);
    if (uid != UID_SegmentationStorage) {
      const char* kind = dcmFindNameOfUID(uid.c_str(), "of an unknown kind");
      file_.fail(phrase("It is a DICOM file, but no segmentation (%1)", kind),
                 "open the segmentation that was made from it");
    }
    require(dataset.findAndGetUint16(DCM_Rows, rows_), diagnostic("It has no number of rows"));
    require(dataset.findAndGetUint16(DCM_Columns, columns_), diagnostic("It has no number of columns"));
    Uint16 largest = 0;
    if (dataset.findAndGetUint16(DCM_MaximumFractionalValue, largest).good() && largest > 0)
      threshold_ = (largest + 1) / 2;
    readPixels(dataset);
    DcmSegmentation* loaded = nullptr;
    const OFCondition condition = DcmSegmentation::loadDataset(dataset, loaded);
    segmentation_.reset(loaded);
    require(condition, diagnostic("its segmentation cannot be read"));
    binary_ = segmentation_->getSegmentationType() == DcmSegTypes::ST_BINARY;
  }

  /// Where the frames are. They are not taken from DCMTK's segmentation: in 3.6.7 that one crashes when the
  /// functional groups speak of more frames than there are.
  void readPixels(DcmDataset& dataset) {
    if (dataset.findAndGetUint8Array(DCM_PixelData, pixels_, &pixelBytes_).bad() || pixels_ == nullptr) {
      const Uint16* words = nullptr;
      unsigned long count = 0;
      require(dataset.findAndGetUint16Array(DCM_PixelData, words, &count),
              diagnostic("It has no uncompressed pixels"));
      pixels_ = reinterpret_cast<const Uint8*>(words);
      pixelBytes_ = pixels_ == nullptr ? 0 : count * sizeof(Uint16);
    }
  }

  void readSize() {
    raw_.size = {axisSize(file_, columns_, "i"), axisSize(file_, rows_, "j"), 1};
    frames_ = segmentation_->getNumberOfFrames();
    if (frames_ == 0)
      file_.fail(diagnostic("It has no frames"), "check that the segmentation was saved");
    const std::uint64_t pixels = saturatedProduct(frames_, std::uint64_t{rows_} * columns_);
    if (pixels / (binary_ ? 8 : 1) + (binary_ && pixels % 8 != 0 ? 1 : 0) > pixelBytes_)
      file_.fail(diagnostic("the file is cut off: its %n {frame has|frames have} too few pixels", frames_));
  }

  /// A functional group of a frame, its own or the one that all frames share.
  template <typename Group>
  Group& group(std::size_t frame, DcmFGTypes::E_FGType type, std::string_view what) {
    auto* found =
        dynamic_cast<Group*>(segmentation_->getFunctionalGroups().get(static_cast<Uint32>(frame), type));
    if (found == nullptr)
      file_.fail(diagnostic("frame %1 has no %2", frame + 1, what));
    return *found;
  }

  void readSlices() {
    for (std::size_t frame = 0; frame < frames_; ++frame) {
      Slice slice{.frame = frame};
      Uint16 segment = 0;
      auto& reference = group<FGSegmentation>(frame, DcmFGTypes::EFG_SEGMENTATION, "segment");
      require(reference.getReferencedSegmentNumber(segment), diagnostic("a frame has no %1", "segment"));
      slice.segment = segment;
      auto& place = group<FGPlanePosPatient>(frame, DcmFGTypes::EFG_PLANEPOSPATIENT, "position");
      Vec3& p = slice.position;
      require(place.getImagePositionPatient(p[0], p[1], p[2]), diagnostic("a frame has no %1", "position"));
      readPlane(frame);
      slices_.push_back(slice);
    }
  }

  /// Directions and spacing, which have to be the same for all frames.
  void readPlane(std::size_t frame) {
    Vec3 row, column;
    auto& orientation =
        group<FGPlaneOrientationPatient>(frame, DcmFGTypes::EFG_PLANEORIENTPATIENT, "orientation");
    require(orientation.getImageOrientationPatient(row[0], row[1], row[2], column[0], column[1], column[2]),
            diagnostic("a frame has no %1", "orientation"));
    auto& measures = group<FGPixelMeasures>(frame, DcmFGTypes::EFG_PIXELMEASURES, "spacing");
    Float64 betweenRows = 0, betweenColumns = 0;
    require(measures.getPixelSpacing(betweenRows, 0), diagnostic("a frame has no %1", "spacing"));
    require(measures.getPixelSpacing(betweenColumns, 1), diagnostic("a frame has no %1", "spacing"));
    Float64 thickness = 0, betweenSlices = 0;
    measures.getSliceThickness(thickness);
    measures.getSpacingBetweenSlices(betweenSlices);
    Eigen::Matrix3d linear;
    linear << row.normalized() * betweenColumns, column.normalized() * betweenRows,
        row.cross(column).normalized() * (betweenSlices > 0 ? betweenSlices : thickness);
    if (frame == 0) {
      raw_.indexToLps.linear() = linear;
      statedSpacing_ = betweenSlices;
    } else if (!((linear - raw_.indexToLps.linear()).norm() <= kSameFrameDirection * linear.norm())) {
      file_.fail("its frames lie in different directions", "convert it to .seg.nrrd");
    }
  }

  /// Along the normal of the slices.
  double heightOf(const Slice& slice) const { return normal_.dot(slice.position - slices_.front().position); }

  void placeGrid() {
    normal_ = raw_.indexToLps.linear().col(0).cross(raw_.indexToLps.linear().col(1)).normalized();
    std::vector<double> heights;
    for (const Slice& slice : slices_)
      heights.push_back(heightOf(slice));
    if (!normal_.allFinite() ||
        !std::all_of(heights.begin(), heights.end(), [](double h) { return std::isfinite(h); }))
      file_.fail(diagnostic("the positions of its frames are not finite"));
    lowest_ = *std::min_element(heights.begin(), heights.end());
    std::sort(heights.begin(), heights.end());
    spacing_ = spacingOf(heights);
    const double count = std::round((heights.back() - lowest_) / spacing_) + 1;
    if (!(count * columns_ * rows_ <= kMostVoxelsPerByte * static_cast<double>(file_.bytes.size())))
      file_.fail(diagnostic("its frames are too far from each other: %1 mm",
                            std::to_string(heights.back() - lowest_)));
    raw_.size[2] = axisSize(file_, static_cast<std::int64_t>(count), "k");
    setSliceDirection();
  }

  /// The spacing that the file states, unless slices are closer; for a single one its thickness.
  double spacingOf(const std::vector<double>& heights) const {
    const double thickness = raw_.indexToLps.linear().col(2).norm();
    const double least = kSliceTolerance * (thickness > 0 ? thickness : 1);
    double smallest = 0;
    for (std::size_t i = 1; i < heights.size(); ++i)
      if (const double gap = heights[i] - heights[i - 1]; gap > least && (smallest == 0 || gap < smallest))
        smallest = gap;
    const bool stated = statedSpacing_ > 0 && (smallest == 0 || statedSpacing_ < smallest);
    const double spacing = stated ? statedSpacing_ : smallest > 0 ? smallest : thickness;
    if (!(spacing > 0) || !std::isfinite(spacing))
      file_.fail(diagnostic("It does not say how far its slices are from each other"));
    return spacing;
  }

  /// From the lowest slice to the highest: slices that are shifted sideways make a sheared grid.
  void setSliceDirection() {
    const auto byHeight = [&](const Slice& a, const Slice& b) { return heightOf(a) < heightOf(b); };
    const auto [first, last] = std::minmax_element(slices_.begin(), slices_.end(), byHeight);
    const int steps = raw_.size[2] - 1;
    raw_.indexToLps.linear().col(2) =
        steps == 0 ? Vec3(normal_ * spacing_) : Vec3((last->position - first->position) / steps);
    raw_.indexToLps.translation() = first->position;
  }

  /// The slice's k.
  int layerOfSlice(const Slice& slice) const {
    const double k = (heightOf(slice) - lowest_) / spacing_;
    const Vec3 expected = raw_.indexToLps * Vec3(0, 0, std::round(k));
    if (std::abs(k - std::round(k)) > kSliceTolerance ||
        (slice.position - expected).norm() > kSliceTolerance * (spacing_ + raw_.indexToLps.linear().norm()))
      file_.fail(phrase("its slices are not equally far from each other (frame %1)", slice.frame + 1),
                 "resample the segmentation, for example by saving it as .seg.nrrd");
    return static_cast<int>(std::round(k));
  }

  void paintSlices() {
    std::map<int, std::vector<const Slice*>> bySegment;
    for (const Slice& slice : slices_)
      bySegment[slice.segment].push_back(&slice);
    std::vector<LabelLayer> layers;
    const auto voxels = static_cast<std::size_t>(raw_.valueCount());
    for (const auto& [segment, list] : bySegment) {
      LabelLayer mask(voxels);
      for (const Slice* slice : list)
        paint(*slice, mask);
      const int layer = addToFreeLayer(layers, mask, static_cast<std::uint16_t>(segment));
      raw_.stated.push_back(statementOf(segment, layer));
    }
    raw_.layers = static_cast<int>(layers.size());
    raw_.scalar = Scalar::uint16;
    raw_.order = std::endian::native;
    for (const LabelLayer& layer : layers)
      for (std::size_t voxel = 0; voxel < layer.size(); ++voxel) {
        const std::uint16_t number = layer[voxel];
        raw_.storage.append(reinterpret_cast<const char*>(&number), sizeof number);
      }
  }

  /// Binary frames follow each other bit by bit, the lowest first, without a gap between frames.
  bool isInside(std::uint64_t pixel) const {
    return binary_ ? (pixels_[pixel / 8] >> (pixel % 8) & 1) != 0 : pixels_[pixel] >= threshold_;
  }

  void paint(const Slice& slice, LabelLayer& mask) const {
    const std::uint64_t pixels = std::uint64_t{rows_} * columns_, first = slice.frame * pixels;
    const std::size_t out = pixels * static_cast<std::size_t>(layerOfSlice(slice));
    for (std::uint64_t p = 0; p < pixels; ++p)
      if (isInside(first + p))
        mask.set(out + p, 1);
  }

  StatedSegment statementOf(int number, int layer) {
    StatedSegment statement{number, layer, {}, {}};
    DcmSegment* segment = number > 0 ? segmentation_->getSegment(static_cast<std::size_t>(number)) : nullptr;
    if (segment == nullptr)
      file_.fail(diagnostic("its frames belong to a segment %1, which it does not have", number));
    OFString label;
    if (segment->getSegmentLabel(label).good())
      statement.name = readable(*format_.getDataset(), label.c_str());
    Uint16 l = 0, a = 0, b = 0;
    if (segment->getRecommendedDisplayCIELabValue(l, a, b).good())
      statement.color = colorOfDicomLab(l, a, b);
    return statement;
  }

  const FileBytes& file_;
  DcmFileFormat format_;
  std::unique_ptr<DcmSegmentation> segmentation_;
  const Uint8* pixels_ = nullptr; ///< Of all frames; they belong to `format_`.
  unsigned long pixelBytes_ = 0;
  RawImage raw_;
  bool binary_ = true;
  int threshold_ = 128; ///< Fractions from here on are inside: one half.
  Uint16 rows_ = 0, columns_ = 0;
  std::size_t frames_ = 0;
  std::vector<Slice> slices_;
  Vec3 normal_ = Vec3::Zero();
  double statedSpacing_ = 0, spacing_ = 0, lowest_ = 0;
};

} // namespace

RawImage readDicomSegmentation(FileBytes& file) {
  return SegmentationReader(file).run();
}

} // namespace viscera::medical_io
