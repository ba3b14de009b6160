#include "dicom/structure_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "image_formats/raw_image.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/squared_distances.h"

namespace viscera::medical_io {
namespace {

constexpr double kSamePlaneMm = 0.02; ///< Contours that are nearer lie in one plane.
constexpr double kLeastStepMm = 0.1;  ///< Slices are not nearer.
constexpr double kAcross = 0.999;     ///< Cosine of the angle of normals that count as one direction.
constexpr double kFlatMm = 0.5;       ///< A contour leaves its plane by this at most.
constexpr double kSinglePlaneMm = 3;  ///< Thickness of a slice that stands alone.
constexpr double kFinest = 0.3;       ///< mm
constexpr double kCoarsest = 1;       ///< mm
constexpr double kPixelsAcross = 25;  ///< Of a region's mean contour: a square of its area has so many.
constexpr double kLongestGap = 4;     ///< Times the usual distance.
constexpr double kOnSlice = 0.05;     ///< Part of a step: a contour so near lies on the slice.

/// Newell's normal, twice as long as the contour's area.
Vec3 areaVector(const Points& corners) {
  Vec3 sum = Vec3::Zero();
  const Vec3 first = corners.row(0).transpose();
  for (Eigen::Index i = 1; i + 1 < corners.rows(); ++i)
    sum += (corners.row(i).transpose() - first).cross(corners.row(i + 1).transpose() - first);
  return sum;
}

/// The normal of the direction with the most area, its largest component positive.
std::optional<Vec3> mainNormal(const StructureSet& set) {
  std::vector<std::pair<Vec3, double>> found;
  for (const DrawnRegion& region : set.regions)
    for (const Points& contour : region.closed) {
      const Vec3 area = areaVector(contour);
      if (!(area.norm() > 1e-6))
        continue;
      Vec3 normal = area.normalized();
      Eigen::Index largest = 0;
      normal.cwiseAbs().maxCoeff(&largest);
      normal *= normal[largest] < 0 ? -1 : 1;
      const auto same = std::find_if(found.begin(), found.end(),
                                     [&](const auto& one) { return one.first.dot(normal) > kAcross; });
      if (same == found.end())
        found.emplace_back(normal, area.norm());
      else
        same->second += area.norm();
    }
  const auto most = std::max_element(found.begin(), found.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == found.end() ? std::nullopt : std::optional(most->first);
}

/// Columns: along a row, along a column, across the slices.
Eigen::Matrix3d axesAround(const Vec3& normal) {
  const Vec3 along = std::abs(normal.x()) > 0.9 ? Vec3::UnitY() : Vec3::UnitX();
  Eigen::Matrix3d axes;
  axes.col(0) = (along - along.dot(normal) * normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

/// The planes of a region; contours aslant are counted.
std::vector<DrawnPlane> planesOf(const DrawnRegion& region, const Eigen::Matrix3d& axes,
                                 std::size_t& aslant) {
  std::vector<DrawnPlane> planes;
  for (const Points& contour : region.closed) {
    const Points own = contour * axes;
    const double offset = own.col(2).mean();
    if ((own.col(2).array() - offset).abs().maxCoeff() > kFlatMm) {
      ++aslant;
      continue;
    }
    const auto same = std::find_if(planes.begin(), planes.end(), [&](const DrawnPlane& plane) {
      return std::abs(plane.offset - offset) < kSamePlaneMm;
    });
    DrawnPlane& plane = same == planes.end() ? planes.emplace_back(DrawnPlane{offset, {}, 0}) : *same;
    plane.contours.emplace_back(own.leftCols<2>().transpose());
    plane.area += 0.5 * areaVector(contour).norm();
  }
  std::sort(planes.begin(), planes.end(),
            [](const DrawnPlane& a, const DrawnPlane& b) { return a.offset < b.offset; });
  return planes;
}

/// What all planes span.
struct Extent {
  Eigen::AlignedBox2d box;
  std::vector<double> offsets; ///< Ascending, each once.
  double pixel = kCoarsest;

  explicit Extent(const std::vector<std::vector<DrawnPlane>>& regions) {
    for (const std::vector<DrawnPlane>& planes : regions) {
      double area = 0;
      for (const DrawnPlane& plane : planes) {
        offsets.push_back(plane.offset);
        area += plane.area / double(planes.size());
        for (const auto& contour : plane.contours)
          for (Eigen::Index i = 0; i < contour.cols(); ++i)
            box.extend(contour.col(i));
      }
      if (area > 0)
        pixel = std::min(pixel, std::max(kFinest, std::sqrt(area) / kPixelsAcross));
    }
    std::sort(offsets.begin(), offsets.end());
    offsets.erase(
        std::unique(offsets.begin(), offsets.end(), [](double a, double b) { return b - a < kSamePlaneMm; }),
        offsets.end());
  }

  /// The distance of the two nearest planes.
  double step() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < offsets.size(); ++i)
      least = std::min(least, std::max(kLeastStepMm, offsets[i] - offsets[i - 1]));
    return offsets.size() > 1 ? least : kSinglePlaneMm;
  }
};

/// How far a region's planes usually are apart.
double usualStep(const std::vector<DrawnPlane>& planes, double step) {
  std::vector<double> apart;
  for (std::size_t i = 1; i < planes.size(); ++i)
    apart.push_back(planes[i].offset - planes[i - 1].offset);
  if (apart.empty())
    return step;
  std::nth_element(apart.begin(), apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2), apart.end());
  return apart[apart.size() / 2];
}

/// One region on the pixels of its box.
class RegionFiller {
public:
  RegionFiller(const StructureGrid& grid, const std::vector<DrawnPlane>& planes)
      : grid_(grid), planes_(planes), pixel_(grid.indexToLps.linear().col(0).norm()),
        step_(grid.indexToLps.linear().col(2).norm()), usual_(usualStep(planes, step_)) {
    const Eigen::Matrix3d axes =
        grid.indexToLps.linear() * Vec3(1 / pixel_, 1 / pixel_, 1 / step_).asDiagonal();
    origin_ = axes.transpose() * grid.indexToLps.translation();
    pixels_ = std::size_t(grid.size[0]) * std::size_t(grid.size[1]);
  }

  FilledRegion run() {
    FilledRegion filled;
    if (planes_.empty())
      return filled;
    const double low = planes_.front().offset - 0.5 * usual_, high = planes_.back().offset + 0.5 * usual_;
    filled.first = std::clamp(sliceAt(low), 0, grid_.size[2] - 1);
    const int last = std::clamp(sliceAt(high) + 1, 0, grid_.size[2] - 1);
    filled.slices = last - filled.first + 1;
    filled.voxels.assign(pixels_ * std::size_t(filled.slices), 0);
    for (int k = 0; k < filled.slices; ++k)
      fill(origin_.z() + (filled.first + k) * step_, filled.voxels.data() + pixels_ * std::size_t(k), filled);
    return filled;
  }

private:
  int sliceAt(double offset) const {
    return static_cast<int>(std::floor((offset - origin_.z()) / step_ + 1e-6));
  }

  void fill(double offset, std::uint8_t* out, FilledRegion& filled) {
    const auto above = std::find_if(planes_.begin(), planes_.end(), [&](const DrawnPlane& plane) {
      return plane.offset >= offset - kOnSlice * step_;
    });
    const bool on = above != planes_.end() && above->offset <= offset + kOnSlice * step_;
    if (on) {
      copy(*above, out);
      return;
    }
    const DrawnPlane* lower = above == planes_.begin() ? nullptr : &*std::prev(above);
    const DrawnPlane* upper = above == planes_.end() ? nullptr : &*above;
    if (lower != nullptr && upper != nullptr && upper->offset - lower->offset <= kLongestGap * usual_) {
      blend(*lower, *upper, (offset - lower->offset) / (upper->offset - lower->offset), out);
      filled.interpolated += upper->offset - lower->offset > 1.5 * usual_ ? 1 : 0;
      return;
    }
    if (lower != nullptr && upper != nullptr)
      filled.gap = std::max(filled.gap, upper->offset - lower->offset);
    // Beyond its contours it ends half its usual distance from them; at the middle only upwards.
    if (upper != nullptr && upper->offset - offset <= 0.5 * usual_ * (1 + 1e-9))
      copy(*upper, out);
    else if (lower != nullptr && offset - lower->offset < 0.5 * usual_ * (1 - 1e-9))
      copy(*lower, out);
  }

  void copy(const DrawnPlane& plane, std::uint8_t* out) const {
    const std::vector<std::uint8_t> mask = maskOf(plane);
    std::copy(mask.begin(), mask.end(), out);
  }

  /// Even-odd, of the centres of pixels.
  std::vector<std::uint8_t> maskOf(const DrawnPlane& plane) const {
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(grid_.size[1]));
    for (const auto& contour : plane.contours)
      for (Eigen::Index a = contour.cols() - 1, b = 0; b < contour.cols(); a = b++)
        addCrossings(contour.col(a), contour.col(b), crossings);
    std::vector<std::uint8_t> mask(pixels_, 0);
    for (std::size_t row = 0; row < crossings.size(); ++row) {
      std::vector<double>& line = crossings[row];
      std::sort(line.begin(), line.end());
      for (std::size_t c = 0; c + 1 < line.size(); c += 2) {
        const int begin = std::clamp(static_cast<int>(std::ceil(line[c])), 0, grid_.size[0]);
        const int end = std::clamp(static_cast<int>(std::ceil(line[c + 1])), begin, grid_.size[0]);
        std::fill_n(mask.begin() + static_cast<std::ptrdiff_t>(row * std::size_t(grid_.size[0])) + begin,
                    end - begin, std::uint8_t{1});
      }
    }
    return mask;
  }

  /// Where an edge crosses the middles of rows, in pixels.
  void addCrossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                    std::vector<std::vector<double>>& crossings) const {
    const Eigen::Vector2d from = (a - origin_.head<2>()) / pixel_, to = (b - origin_.head<2>()) / pixel_;
    const double low = std::min(from.y(), to.y()), high = std::max(from.y(), to.y());
    const int begin = std::max(0, static_cast<int>(std::ceil(low)));
    const int end = std::min(grid_.size[1], static_cast<int>(std::ceil(high)));
    for (int row = begin; row < end; ++row)
      crossings[std::size_t(row)].push_back(from.x() +
                                            (row - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
  }

  /// Negative inside, in pixels, from the border between pixels.
  std::vector<float> distances(const DrawnPlane& plane) const {
    const std::vector<std::uint8_t> mask = maskOf(plane);
    const std::array<int, 3> size = {grid_.size[0], grid_.size[1], 1};
    const std::array<bool, 3> along = {true, true, false};
    const auto to = [&](std::uint8_t value) {
      return geometry::squaredDistances(mask, value, size, Vec3::Ones(), along, Threads{1});
    };
    std::vector<float> out = to(1);
    const std::vector<float> in = to(0);
    for (std::size_t p = 0; p < out.size(); ++p)
      out[p] = mask[p] != 0 ? 0.5F - std::sqrt(in[p]) : std::sqrt(out[p]) - 0.5F;
    return out;
  }

  void blend(const DrawnPlane& lower, const DrawnPlane& upper, double share, std::uint8_t* out) {
    if (blendedLow_ != &lower) {
      low_ = distances(lower);
      high_ = distances(upper);
      blendedLow_ = &lower;
    }
    for (std::size_t p = 0; p < pixels_; ++p)
      out[p] = (1 - share) * double(low_[p]) + share * double(high_[p]) < 0 ? 1 : 0;
  }

  const StructureGrid& grid_;
  const std::vector<DrawnPlane>& planes_;
  double pixel_, step_, usual_;
  Vec3 origin_; ///< The first voxel's centre in the grid's axes, mm.
  std::size_t pixels_ = 0;
  const DrawnPlane* blendedLow_ = nullptr; ///< Whose distances `low_` are.
  std::vector<float> low_, high_;
};

} // namespace

StructureGrid structureGrid(const StructureSet& set, const FileBytes& file, std::size_t mostVoxels) {
  const std::optional<Vec3> normal = mainNormal(set);
  if (!normal)
    file.fail("It is a structure set without closed contours, so that there is no organ in it",
              "export the structures as closed planar contours");
  const Eigen::Matrix3d axes = axesAround(*normal);
  StructureGrid grid;
  for (const DrawnRegion& region : set.regions)
    grid.regions.push_back(planesOf(region, axes, grid.aslant));
  Extent extent(grid.regions);
  const double step = extent.step();
  grid.single = extent.offsets.size() == 1;
  const double depth = extent.offsets.back() - extent.offsets.front();
  const Eigen::Vector2d sides = extent.box.sizes();
  double usual = step;
  for (const std::vector<DrawnPlane>& planes : grid.regions)
    usual = std::max(usual, usualStep(planes, step));
  const double beyond = std::ceil(0.5 * usual / step); // Slices for what a contour stands for beyond it.
  const double slices = std::floor(depth / step + 0.5) + 1 + 2 * beyond;
  const double voxels = (sides.x() / extent.pixel + 3) * (sides.y() / extent.pixel + 3) * slices;
  double pixel = extent.pixel;
  if (voxels > double(mostVoxels))
    pixel *= std::sqrt(voxels / double(mostVoxels));
  const auto cells = [&](double length) {
    return axisSize(file, static_cast<std::int64_t>(std::ceil(std::min(length, 1e9))), "a structure");
  };
  grid.size = {cells(sides.x() / pixel + 2), cells(sides.y() / pixel + 2), cells(slices)};
  const Vec3 origin(extent.box.min().x() - 0.5 * pixel, extent.box.min().y() - 0.5 * pixel,
                    extent.offsets.front() - beyond * step);
  grid.indexToLps.linear() = axes * Vec3(pixel, pixel, step).asDiagonal();
  grid.indexToLps.translation() = axes * origin;
  return grid;
}

FilledRegion fillRegion(const StructureGrid& grid, std::size_t region) {
  return RegionFiller(grid, grid.regions.at(region)).run();
}

} // namespace viscera::medical_io
