#include "viscera/coordinates/coordinate_system.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace viscera::coordinates {
namespace {

/// Part of the handles' diagonal. Rounding (1e-16 / step) and truncation (step^2) then both stay below 1e-10.
constexpr double kRelativeStep = 1e-5;
constexpr Eigen::Index kOffsets = 6;

/// Each point moved by `step` forward and back along x, y and z: six rows a point.
Points displaced(const Points& points, double step) {
  Points moved(points.rows() * kOffsets, 3);
  for (Eigen::Index point = 0; point < points.rows(); ++point)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      for (Eigen::Index side = 0; side < 2; ++side) {
        auto row = moved.row(point * kOffsets + 2 * axis + side);
        row = points.row(point);
        row[axis] += side == 0 ? step : -step;
      }
  return moved;
}

/// The points of which any displaced copy failed.
std::vector<int> failedPoints(const std::vector<int>& failedCopies) {
  std::vector<int> failures;
  for (const int copy : failedCopies)
    failures.push_back(copy / static_cast<int>(kOffsets));
  failures.erase(std::unique(failures.begin(), failures.end()), failures.end());
  return failures;
}

} // namespace

CoordinateGradients CoordinateSystem::gradients(const HandleSet& handles, const Points& points,
                                                const BindOptions& options, Progress& progress) const {
  const double step = kRelativeStep * boundsOf(handles.positions).diagonal();
  BindOptions exact = options; // Differences would magnify the rounding of single precision.
  exact.mostBytesInDoubles = std::numeric_limits<std::size_t>::max();
  const auto binding = bind(handles, displaced(points, step), exact, progress);
  const Eigen::Index count = binding->handleCount();
  CoordinateGradients result;
  result.values.resize(points.rows() * count, 3);
  for (Eigen::Index handle = 0; handle < count; ++handle) {
    const Values values = binding->influence(static_cast<int>(handle));
    for (Eigen::Index point = 0; point < points.rows(); ++point)
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        // da/dx = (a(x + h) - a(x - h)) / (2 h), but for h^2 / 6 of the third derivative.
        const Eigen::Index forward = point * kOffsets + 2 * axis;
        result.values(point * count + handle, axis) = (values[forward] - values[forward + 1]) / (2 * step);
      }
  }
  result.failures = failedPoints(binding->report().failures);
  for (const int point : result.failures)
    result.values.middleRows(point * count, count).setZero();
  return result;
}

SpaceLayout CoordinateSystem::layout(const HandleSet&, const ParameterValues&) const {
  return {};
}

} // namespace viscera::coordinates
