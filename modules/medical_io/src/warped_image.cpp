#include "viscera/medical_io/warped_image.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>

#include "label_segments.h"
#include "scan_sampling.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr Eigen::Index kRows = 8;       ///< Rows of a slice that a thread fills in one go.
constexpr std::size_t kMeasured = 4000; ///< About so many voxels are kept for measuring.
constexpr double kRefined = 0.4; ///< Of the accuracy: how near refinement comes; the rest is the grid's.
/// Bound points times handles: a hundred megabytes. What is finer than that grid is refined.
constexpr double kMostWeights = 1.2e7;

/// The grid of an image.
struct Grid {
  std::array<int, 3> size;
  Eigen::Affine3d indexToLps;

  std::size_t voxels() const { return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]); }
  deformation::SamplePlane slice(int k) const {
    return {indexToLps * Vec3(0, 0, k), indexToLps.linear().col(0), indexToLps.linear().col(1), size[0],
            size[1]};
  }
};

/// Counts what moved, and keeps some of it to measure.
class Reporter {
public:
  Reporter(const Grid& grid, WarpReport& report)
      : grid_(grid), report_(report), step_(grid.voxels() / kMeasured + 1) {
    report_ = {};
  }

  /// `soft` is what the map gave, whose error is measured where nothing stiff has changed it.
  void add(int k, const deformation::RestPoints& rest, const deformation::RestPoints& soft) {
    const std::size_t slice = rest.states.size();
    for (std::size_t v = 0; v < slice; ++v) {
      if (rest.states[v] == deformation::RestState::still)
        continue;
      ++report_.moved;
      report_.folded += rest.states[v] == deformation::RestState::folded ? 1U : 0U;
      const auto row = static_cast<Eigen::Index>(v);
      if (report_.moved % step_ != 0 || rest.points.row(row) != soft.points.row(row))
        continue;
      const int i = static_cast<int>(v % std::size_t(grid_.size[0]));
      const int j = static_cast<int>(v / std::size_t(grid_.size[0]));
      posed_.push_back(grid_.indexToLps * Vec3(i, j, k));
      rest_.push_back(rest.points.row(row).transpose());
      states_.push_back(rest.states[v]);
    }
  }
  void finish(const Warp& warp, Progress& progress) {
    report_.largestErrorMm =
        warp.map.residualMm(warp.system, pointsOf(posed_), {pointsOf(rest_), states_}, progress);
  }

private:
  const Grid& grid_;
  WarpReport& report_;
  std::size_t step_;
  std::vector<Vec3> posed_, rest_;
  std::vector<deformation::RestState> states_;
};

/// Calls `fill(voxel, index at rest)` for every voxel that moves, slice by slice, on several threads; `index`
/// is in voxels of the grid.
void warpGrid(const Grid& grid, const Warp& warp, WarpReport& report, Progress& progress,
              const std::function<void(std::size_t voxel, const Vec3& index)>& fill) {
  Reporter reporter(grid, report);
  const double tolerance = kRefined * kWarpAccuracy * grid.indexToLps.linear().colwise().norm().minCoeff();
  const Eigen::Affine3d lpsToIndex = grid.indexToLps.inverse();
  deformation::RestPoints rest, soft;
  const std::size_t slice = std::size_t(grid.size[0]) * std::size_t(grid.size[1]);
  for (int k = 0; k < grid.size[2]; ++k) {
    progress.report(static_cast<double>(k) / grid.size[2], "Warping the image");
    progress.throwIfCancelled();
    warp.map.restPlane(grid.slice(k), rest);
    warp.map.refinePlane(warp.system, grid.slice(k), {.toleranceMm = tolerance}, rest, progress);
    if (warp.stiff) {
      soft = rest;
      warp.stiff->stiffen(grid.slice(k), rest);
    }
    reporter.add(k, rest, warp.stiff ? soft : rest);
    const std::size_t begin = slice * std::size_t(k);
    parallelRanges(grid.size[1], kRows, {}, [&](Eigen::Index first, Eigen::Index last) {
      for (auto v = std::size_t(first) * std::size_t(grid.size[0]);
           v < std::size_t(last) * std::size_t(grid.size[0]); ++v)
        if (rest.states[v] != deformation::RestState::still)
          fill(begin + v, lpsToIndex * Vec3(rest.points.row(static_cast<Eigen::Index>(v)).transpose()));
    });
  }
  reporter.finish(warp, progress);
  progress.report(1);
}

/// The value of voxels without a measurement.
template <class Sample>
Sample emptySample(const Scan& scan, const std::vector<Sample>& samples) {
  if constexpr (std::is_floating_point_v<Sample>)
    if (!scan.padding)
      return std::numeric_limits<Sample>::quiet_NaN();
  if (scan.padding)
    return static_cast<Sample>(*scan.padding);
  if (samples.empty())
    return 0;
  return scan.slope > 0 ? *std::min_element(samples.begin(), samples.end())
                        : *std::max_element(samples.begin(), samples.end());
}

template <class Sample>
Sample rounded(double value) {
  if constexpr (std::is_floating_point_v<Sample>)
    return static_cast<Sample>(value);
  else
    return static_cast<Sample>(std::lround(value)); // A mean of samples fits.
}

/// Counts every segment's voxels; those without any are left out.
void countAgain(LabelMap& map, Progress& progress) {
  for (Segment& segment : map.segments)
    segment.voxels = 0;
  measureSegments(map, progress);
  std::vector<std::uint16_t> numbers(map.segments.size() + 1, 0);
  std::vector<Segment> kept;
  for (std::size_t s = 0; s < map.segments.size(); ++s) {
    if (map.segments[s].voxels == 0) {
      map.warnings.push_back(phrase("%1 has no voxels any more", named(map.segments[s].name)));
      continue;
    }
    kept.push_back(map.segments[s]);
    numbers[s + 1] = static_cast<std::uint16_t>(kept.size());
  }
  if (kept.size() == map.segments.size())
    return;
  map.segments = std::move(kept);
  for (LabelLayer& layer : map.layers)
    for (std::size_t voxel = 0; voxel < layer.size(); ++voxel)
      layer.set(voxel, numbers[layer[voxel]]);
}

} // namespace

deformation::InverseMapOptions warpOptions(const Vec3& spacing) {
  return {.accuracyMm = kWarpAccuracy * spacing.minCoeff(), .mostWeights = kMostWeights};
}

Scan warpedScan(const Scan& scan, const Warp& warp, WarpReport& report, Progress& progress) {
  Scan warped = scan;
  std::visit(
      [&]<class Sample>(std::vector<Sample>& out) {
        const auto& samples = std::get<std::vector<Sample>>(scan.samples);
        const TrilinearSampler<Sample> sampler(samples, scan.size, scan.padding);
        const Sample empty = emptySample(scan, samples);
        warpGrid({scan.size, scan.indexToLps}, warp, report, progress,
                 [&](std::size_t voxel, const Vec3& index) {
                   const std::optional<double> value = sampler(index);
                   out[voxel] = value ? rounded<Sample>(*value) : empty;
                 });
      },
      warped.samples);
  return warped;
}

LabelMap warpedLabelMap(const LabelMap& map, const Warp& warp, WarpReport& report, Progress& progress) {
  LabelMap warped = map;
  warpGrid({map.size, map.indexToLps}, warp, report, progress, [&](std::size_t voxel, const Vec3& index) {
    std::array<int, 3> nearest;
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = std::round(index[static_cast<Eigen::Index>(axis)]);
      inside = inside && at >= 0 && at < map.size[axis];
      nearest[axis] = inside ? static_cast<int>(at) : 0;
    }
    const std::size_t from = map.indexOf(nearest[0], nearest[1], nearest[2]);
    for (std::size_t layer = 0; layer < map.layers.size(); ++layer)
      warped.layers[layer].set(voxel, inside ? map.layers[layer][from] : std::uint16_t{0});
  });
  countAgain(warped, progress);
  return warped;
}

} // namespace viscera::medical_io
