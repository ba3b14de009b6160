#include "implicit/surface_path.h"

#include <algorithm>

namespace viscera::organs {
namespace {

constexpr double kPathStep = 3.0;       // mm between points that are projected
constexpr double kClosest = 1.0;        // mm; nearer neighbours make the tube's axis shake
constexpr double kLongestStep = 4.0;    // mm
constexpr double kSmallestSlope2 = 0.1; // squared
constexpr int kGrooveSteps = 8;
constexpr int kSurfaceSteps = 8;

/// Moves a point along the surface to where the two nodes are equally far.
Vec3 intoGroove(const ImplicitNode& base, const NodePtr (&between)[2], Vec3 point) {
  for (int step = 0; step < kGrooveSteps; ++step) {
    const double difference = between[0]->distance(point) - between[1]->distance(point);
    const Vec3 slope = gradient(*between[0], point) - gradient(*between[1], point);
    Vec3 move = -difference / std::max(slope.squaredNorm(), kSmallestSlope2) * slope;
    const double length = move.norm();
    if (length > kLongestStep)
      move *= kLongestStep / length;
    point = projected(base, point + move, 2);
  }
  return point;
}

std::vector<Vec3> denseRoughPath(const std::vector<Vec3>& points) {
  std::vector<AxisPoint> axis;
  for (const Vec3& point : points)
    axis.push_back({point, 1});
  std::vector<Vec3> dense;
  for (const AxisSample& sample : sampleAxis(axis, kPathStep, Vec3::UnitY()))
    dense.push_back(sample.position);
  return dense;
}

void smoothOnSurface(const ImplicitNode& base, std::vector<Vec3>& path) {
  const std::vector<Vec3> old = path;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    path[i] = projected(base, 0.25 * old[i - 1] + 0.5 * old[i] + 0.25 * old[i + 1], 3);
}

} // namespace

std::vector<AxisPoint> axisOnSurface(const ImplicitNode& base, const SurfacePath& path) {
  std::vector<Vec3> dense = denseRoughPath(path.points);
  for (Vec3& point : dense) {
    if (path.between[0])
      point = intoGroove(base, path.between, point);
    point = projected(base, point, kSurfaceSteps);
  }
  for (int round = 0; round < path.smoothing; ++round)
    smoothOnSurface(base, dense);

  std::vector<AxisPoint> axis;
  const double last = static_cast<double>(dense.size()) - 1;
  for (std::size_t i = 0; i < dense.size(); ++i) {
    const double share = static_cast<double>(i) / last;
    const double radius = path.startRadius + share * (path.endRadius - path.startRadius);
    const Vec3 lifted = dense[i] + path.lift * radius * gradient(base, dense[i]).normalized();
    if (axis.empty() || (lifted - axis.back().position).norm() > kClosest)
      axis.push_back({lifted, radius});
  }
  if (axis.size() < 2)
    axis.clear();
  return axis;
}

} // namespace viscera::organs
