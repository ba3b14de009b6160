#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "dicom_object.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/tracking/mask.h"

namespace viscera::clinic {
namespace {

constexpr double kEvenSlices = 0.02; ///< Of the distance of slices.

/// A slice of a segment with a voxel in it.
struct Frame {
  std::size_t segment = 0;
  int slice = 0;
};

tracking::Mask filled(const WrittenOrgan& organ, const WrittenGrid& grid) {
  tracking::Mask empty;
  empty.size = grid.size;
  empty.indexToLps = grid.indexToLps;
  tracking::Mask mask = tracking::voxelised(*organ.surface, empty);
  if (mask.count() == 0)
    throw DataError("No voxel of the grid lies within the organ", organ.name,
                    "choose the scan that shows it, or smaller voxels");
  return mask;
}

/// One bit a pixel, the first one lowest; frames follow each other without a gap.
class PackedFrames {
public:
  explicit PackedFrames(std::size_t pixels) : pixels_(pixels) {}

  void add(const std::uint8_t* mask) {
    bytes_.resize((bits_ + pixels_ + 7) / 8, 0);
    for (std::size_t p = 0; p < pixels_; ++p, ++bits_)
      if (mask[p] != 0)
        bytes_[bits_ / 8] = static_cast<Uint8>(bytes_[bits_ / 8] | 1U << bits_ % 8);
  }
  std::vector<Uint8> even() && {
    if (bytes_.size() % 2 != 0)
      bytes_.push_back(0);
    return std::move(bytes_);
  }

private:
  std::size_t pixels_, bits_ = 0;
  std::vector<Uint8> bytes_;
};

class SegmentationWriter {
public:
  SegmentationWriter(const StudyIdentity& identity, const ObjectSeries& series, const WrittenGrid& grid)
      : identity_(identity), series_(series), grid_(grid), dataset_(*format_.getDataset()),
        spacing_(grid.indexToLps.linear().colwise().norm()) {}

  WrittenObject run(const std::filesystem::path& file, const std::vector<WrittenOrgan>& organs,
                    Progress& progress) {
    putHeader();
    putSegments(organs);
    fill(organs, progress);
    putShared();
    putDimensions();
    bool onImages = false;
    for (const Frame& frame : frames_)
      onImages = putFrame(frame) || onImages;
    if (onImages)
      putReferencedSeries(dataset_, identity_);
    put(dataset_, DCM_NumberOfFrames, std::to_string(frames_.size()));
    if (dataset_.putAndInsertUint8Array(DCM_PixelData, pixels_.data(), pixels_.size()).bad())
      throw CannotCreateError(misuse("DCMTK cannot write the pixels"), file.string());
    WrittenObject written = save(format_, file, series_);
    for (const WrittenOrgan& organ : organs)
      written.segments.push_back(organ.name);
    return written;
  }

private:
  void putHeader() {
    putCommon(dataset_, identity_, series_, UID_SegmentationStorage, "SEG");
    put(dataset_, DCM_FrameOfReferenceUID, identity_.frameOfReference);
    put(dataset_, DCM_PositionReferenceIndicator, "");
    put(dataset_, DCM_ContentDate, series_.dateTime.substr(0, 8));
    put(dataset_, DCM_ContentTime, series_.dateTime.substr(8));
    put(dataset_, DCM_ImageType, "DERIVED\\PRIMARY");
    putWord(dataset_, DCM_SamplesPerPixel, 1);
    put(dataset_, DCM_PhotometricInterpretation, "MONOCHROME2");
    putWord(dataset_, DCM_Rows, grid_.size[1]);
    putWord(dataset_, DCM_Columns, grid_.size[0]);
    putWord(dataset_, DCM_BitsAllocated, 1);
    putWord(dataset_, DCM_BitsStored, 1);
    putWord(dataset_, DCM_HighBit, 0);
    putWord(dataset_, DCM_PixelRepresentation, 0);
    put(dataset_, DCM_LossyImageCompression, "00");
    put(dataset_, DCM_SegmentationType, "BINARY");
    put(dataset_, DCM_ContentLabel, "ORGANS");
    put(dataset_, DCM_ContentDescription, series_.note);
    put(dataset_, DCM_ContentCreatorName, "");
  }

  void putSegments(const std::vector<WrittenOrgan>& organs) {
    int number = 0;
    for (const WrittenOrgan& organ : organs) {
      DcmItem& item = addItem(dataset_, DCM_SegmentSequence);
      putWord(item, DCM_SegmentNumber, ++number);
      put(item, DCM_SegmentLabel, organ.name);
      put(item, DCM_SegmentAlgorithmType, "SEMIAUTOMATIC");
      put(item, DCM_SegmentAlgorithmName, "Viscera");
      putColor(item, organ.color);
      putCode(item, DCM_SegmentedPropertyCategoryCodeSequence, {"123037004", "SCT", "Anatomical Structure"});
      const PartCode code = codeOf(organ.name);
      putCode(item, DCM_SegmentedPropertyTypeCodeSequence, code.type);
      if (code.side) {
        DcmItem* type = nullptr;
        if (item.findAndGetSequenceItem(DCM_SegmentedPropertyTypeCodeSequence, type, 0).good())
          putCode(*type, DCM_SegmentedPropertyTypeModifierCodeSequence, *code.side);
      }
    }
  }

  void fill(const std::vector<WrittenOrgan>& organs, Progress& progress) {
    const std::size_t pixels = std::size_t(grid_.size[0]) * std::size_t(grid_.size[1]);
    PackedFrames packed(pixels);
    for (std::size_t o = 0; o < organs.size(); ++o) {
      progress.report(double(o) / double(organs.size()), "voxels");
      const tracking::Mask mask = filled(organs[o], grid_);
      for (int k = 0; k < grid_.size[2]; ++k) {
        const std::uint8_t* slice = mask.inside.data() + pixels * std::size_t(k);
        if (std::all_of(slice, slice + pixels, [](std::uint8_t voxel) { return voxel == 0; }))
          continue;
        frames_.push_back({o, k});
        packed.add(slice);
      }
    }
    pixels_ = std::move(packed).even();
    progress.report(1);
  }

  void putShared() {
    DcmItem& shared = addItem(dataset_, DCM_SharedFunctionalGroupsSequence);
    DcmItem& measures = addItem(shared, DCM_PixelMeasuresSequence);
    putNumbers(measures, DCM_PixelSpacing, {spacing_.y(), spacing_.x()});
    putNumbers(measures, DCM_SliceThickness, {spacing_.z()});
    putNumbers(measures, DCM_SpacingBetweenSlices, {spacing_.z()});
    DcmItem& orientation = addItem(shared, DCM_PlaneOrientationSequence);
    const Vec3 row = grid_.indexToLps.linear().col(0) / spacing_.x();
    const Vec3 column = grid_.indexToLps.linear().col(1) / spacing_.y();
    putNumbers(orientation, DCM_ImageOrientationPatient,
               {row.x(), row.y(), row.z(), column.x(), column.y(), column.z()});
  }

  void putDimensions() {
    const std::string uid = uidFrom(series_.instanceUid, "dimensions");
    put(addItem(dataset_, DCM_DimensionOrganizationSequence), DCM_DimensionOrganizationUID, uid);
    const auto index = [&](const DcmTagKey& of, const DcmTagKey& within) {
      DcmItem& item = addItem(dataset_, DCM_DimensionIndexSequence);
      put(item, DCM_DimensionOrganizationUID, uid);
      item.putAndInsertTagKey(DCM_DimensionIndexPointer, of);
      item.putAndInsertTagKey(DCM_FunctionalGroupPointer, within);
    };
    index(DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence);
    index(DCM_ImagePositionPatient, DCM_PlanePositionSequence);
  }

  /// Whether it lies on an image.
  bool putFrame(const Frame& frame) {
    DcmItem& groups = addItem(dataset_, DCM_PerFrameFunctionalGroupsSequence);
    const Uint32 place[2] = {static_cast<Uint32>(frame.segment + 1), static_cast<Uint32>(frame.slice + 1)};
    if (addItem(groups, DCM_FrameContentSequence)
            .putAndInsertUint32Array(DCM_DimensionIndexValues, place, 2)
            .bad())
      throw CannotCreateError(misuse("DCMTK cannot write the dimensions"));
    putPoint(addItem(groups, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
             Vec3(grid_.indexToLps * Vec3(0, 0, frame.slice)));
    putWord(addItem(groups, DCM_SegmentIdentificationSequence), DCM_ReferencedSegmentNumber,
            static_cast<int>(frame.segment) + 1);
    return putSource(groups, frame.slice);
  }

  /// The image that a frame lies on, where the grid is that of the images.
  bool putSource(DcmItem& groups, int slice) {
    const Vec3 place = grid_.indexToLps * Vec3(0, 0, slice);
    const auto image =
        std::find_if(identity_.images.begin(), identity_.images.end(),
                     [&](const SourceImage& one) { return (one.position - place).norm() < 0.01; });
    if (image == identity_.images.end())
      return false;
    DcmItem& derivation = addItem(groups, DCM_DerivationImageSequence);
    putCode(derivation, DCM_DerivationCodeSequence, {"113076", "DCM", "Segmentation"});
    DcmItem& source = addItem(derivation, DCM_SourceImageSequence);
    put(source, DCM_ReferencedSOPClassUID, image->classUid);
    put(source, DCM_ReferencedSOPInstanceUID, image->instanceUid);
    putCode(source, DCM_PurposeOfReferenceCodeSequence,
            {"121322", "DCM", "Source image for image processing operation"});
    return true;
  }

  const StudyIdentity& identity_;
  const ObjectSeries& series_;
  const WrittenGrid& grid_;
  DcmFileFormat format_;
  DcmDataset& dataset_;
  Vec3 spacing_;
  std::vector<Frame> frames_;
  std::vector<Uint8> pixels_;
};

} // namespace

WrittenGrid gridOfImages(const StudyIdentity& identity) {
  const std::vector<SourceImage>& images = identity.images;
  if (images.size() < 2)
    throw DataError("There are fewer than two images to lay a segmentation on",
                    misuse("%n {image|images}", images.size()), "choose a series of slices");
  const SourceImage& first = images.front();
  const Vec3 step = (images.back().position - first.position) / double(images.size() - 1);
  for (std::size_t k = 0; k < images.size(); ++k)
    if ((images[k].position - first.position - double(k) * step).norm() > kEvenSlices * step.norm())
      throw DataError("The images lie at unequal distances, so that they have no grid",
                      misuse("slice %1", k + 1), "write the segmentation on a grid of its own");
  WrittenGrid grid;
  grid.size = {first.columns, first.rows, static_cast<int>(images.size())};
  grid.indexToLps.linear().col(0) = first.betweenColumns * first.row;
  grid.indexToLps.linear().col(1) = first.betweenRows * first.column;
  grid.indexToLps.linear().col(2) = step;
  grid.indexToLps.translation() = first.position;
  return grid;
}

WrittenGrid gridAround(const std::vector<WrittenOrgan>& organs, double spacingMm) {
  if (!(spacingMm > 0))
    throw UsageError("The size of voxels has to be positive", inDigits(spacingMm, 3));
  Eigen::AlignedBox3d box;
  for (const WrittenOrgan& organ : organs)
    for (const Vec3& corner : {boundsOf(organ.surface->points).low, boundsOf(organ.surface->points).high})
      box.extend(corner);
  WrittenGrid grid;
  for (int axis = 0; axis < 3; ++axis) {
    const double voxels = std::ceil(box.sizes()[axis] / spacingMm) + 2;
    if (!(voxels <= std::numeric_limits<std::uint16_t>::max()))
      throw DataError("The organs are too large for voxels of that size", inDigits(spacingMm, 3),
                      "choose larger voxels");
    grid.size[std::size_t(axis)] = static_cast<int>(voxels);
  }
  grid.indexToLps.linear() = spacingMm * Eigen::Matrix3d::Identity();
  grid.indexToLps.translation() = box.min() - Vec3::Constant(0.5 * spacingMm);
  return grid;
}

WrittenObject writeSegmentation(const std::filesystem::path& file, const StudyIdentity& identity,
                                const ObjectSeries& series, const WrittenGrid& grid,
                                const std::vector<WrittenOrgan>& organs, Progress& progress) {
  return SegmentationWriter(identity, series, grid).run(file, organs, progress);
}

} // namespace viscera::clinic
