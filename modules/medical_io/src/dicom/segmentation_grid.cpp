#include "dicom/segmentation_grid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "image_formats/raw_image.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// Slices whose distance is this much of the spacing off a whole number are no stack.
constexpr double kSliceTolerance = 0.05;
/// Frames without voxels may be left out of the file, but a volume of more voxels than this a byte is an
/// error in a position, not a patient.
constexpr double kMostVoxelsPerByte = 4096;
constexpr double kSameFrameDirection = 1e-4;

class GridPlacement {
public:
  GridPlacement(const DicomHeader& header, const FileBytes& file) : header_(header), file_(file) {}

  SegmentationGrid run() {
    grid_.size = {axisSize(file_, header_.columns, "i"), axisSize(file_, header_.rows, "j"), 1};
    if (header_.frames.empty())
      file_.fail(diagnostic("It has no frames"), "check that the segmentation was saved");
    for (const DicomFrame& frame : header_.frames)
      requireSamePlane(frame);
    const Eigen::Matrix3d& linear = grid_.indexToLps.linear();
    normal_ = linear.col(0).cross(linear.col(1)).normalized();
    placeSlices();
    for (const DicomFrame& frame : header_.frames)
      grid_.layers.push_back(layerOf(frame));
    return std::move(grid_);
  }

private:
  /// Directions and spacing have to be the same for all frames.
  void requireSamePlane(const DicomFrame& frame) {
    Eigen::Matrix3d linear;
    linear << frame.row * frame.betweenColumns, frame.column * frame.betweenRows,
        frame.normal() * frame.thickness;
    if (&frame == &header_.frames.front())
      grid_.indexToLps.linear() = linear;
    else if (!((linear - grid_.indexToLps.linear()).norm() <= kSameFrameDirection * linear.norm()))
      file_.fail("its frames lie in different directions", "convert it to .seg.nrrd");
  }

  /// Along the normal of the slices.
  double heightOf(const DicomFrame& frame) const {
    return normal_.dot(frame.position - header_.frames.front().position);
  }

  void placeSlices() {
    std::vector<double> heights;
    for (const DicomFrame& frame : header_.frames)
      heights.push_back(heightOf(frame));
    if (!normal_.allFinite() ||
        !std::all_of(heights.begin(), heights.end(), [](double h) { return std::isfinite(h); }))
      file_.fail(diagnostic("the positions of its frames are not finite"));
    std::sort(heights.begin(), heights.end());
    lowest_ = heights.front();
    spacing_ = spacingOf(heights);
    const double count = std::round((heights.back() - lowest_) / spacing_) + 1;
    const auto bytes = static_cast<double>(std::max<std::uint64_t>(file_.length, file_.bytes.size()));
    if (!(count * header_.columns * header_.rows <= kMostVoxelsPerByte * bytes))
      file_.fail(diagnostic("its frames are too far from each other: %1 mm",
                            std::to_string(heights.back() - lowest_)));
    grid_.size[2] = axisSize(file_, static_cast<std::int64_t>(count), "k");
    setSliceDirection();
  }

  /// The spacing that the file states, unless slices are closer; for a single one its thickness.
  double spacingOf(const std::vector<double>& heights) const {
    const DicomFrame& first = header_.frames.front();
    const double least = kSliceTolerance * (first.thickness > 0 ? first.thickness : 1);
    double smallest = 0;
    for (std::size_t i = 1; i < heights.size(); ++i)
      if (const double gap = heights[i] - heights[i - 1]; gap > least && (smallest == 0 || gap < smallest))
        smallest = gap;
    const bool stated = first.betweenSlices > 0 && (smallest == 0 || first.betweenSlices < smallest);
    const double spacing = stated ? first.betweenSlices : smallest > 0 ? smallest : first.thickness;
    if (!(spacing > 0) || !std::isfinite(spacing))
      file_.fail(diagnostic("It does not say how far its slices are from each other"));
    return spacing;
  }

  /// The third axis leads from the lowest slice to the highest: slices shifted sideways make a sheared grid.
  void setSliceDirection() {
    const auto byHeight = [&](const DicomFrame& a, const DicomFrame& b) { return heightOf(a) < heightOf(b); };
    const auto [first, last] = std::minmax_element(header_.frames.begin(), header_.frames.end(), byHeight);
    const int steps = grid_.size[2] - 1;
    grid_.indexToLps.linear().col(2) =
        steps == 0 ? Vec3(normal_ * spacing_) : Vec3((last->position - first->position) / steps);
    grid_.indexToLps.translation() = first->position;
  }

  int layerOf(const DicomFrame& frame) const {
    const double k = (heightOf(frame) - lowest_) / spacing_;
    const Vec3 expected = grid_.indexToLps * Vec3(0, 0, std::round(k));
    if (std::abs(k - std::round(k)) > kSliceTolerance ||
        (frame.position - expected).norm() > kSliceTolerance * (spacing_ + grid_.indexToLps.linear().norm()))
      file_.fail(phrase("its slices are not equally far from each other (frame %1)", frame.frame + 1),
                 "resample the segmentation, for example by saving it as .seg.nrrd");
    return static_cast<int>(std::round(k));
  }

  const DicomHeader& header_;
  const FileBytes& file_;
  SegmentationGrid grid_;
  Vec3 normal_ = Vec3::Zero();
  double spacing_ = 0, lowest_ = 0;
};

} // namespace

SegmentationGrid segmentationGrid(const DicomHeader& header, const FileBytes& file) {
  return GridPlacement(header, file).run();
}

} // namespace viscera::medical_io
