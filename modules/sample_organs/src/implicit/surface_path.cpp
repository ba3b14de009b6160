#include "implicit/surface_path.h"

#include <algorithm>

#include "implicit/smooth_functions.h"

namespace viscera::sample_organs {
namespace {

constexpr double kPathStep = 3.0;           // mm between points that are projected
constexpr double kClosest = 1.0;            // mm; nearer neighbours make the tube's axis shake
constexpr double kLongestPathStep = 4.0;    // mm
constexpr double kSmallestPathSlope2 = 0.1; // squared
constexpr double kSunk = -1.3;              // lift in radii at which nothing is seen of a vessel
constexpr double kThinnest = 0.45;          // share of its radius that is left where it has sunk
constexpr int kGrooveSteps = 8;
constexpr int kSurfaceSteps = 8;

/// Moves a point along the surface to where the two nodes are equally far.
Vec3 intoGroove(const ImplicitNode& base, const NodePtr (&between)[2], Vec3 point) {
  for (int step = 0; step < kGrooveSteps; ++step) {
    // A Newton step for f = d_0 - d_1 = 0 along its own gradient: -f grad f / |grad f|^2.
    const double difference = between[0]->distance(point) - between[1]->distance(point);
    const Vec3 slope = gradient(*between[0], point) - gradient(*between[1], point);
    Vec3 move = -difference / std::max(slope.squaredNorm(), kSmallestPathSlope2) * slope;
    const double length = move.norm();
    if (length > kLongestPathStep)
      move *= kLongestPathStep / length;
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

/// How much of the vessel is out of the surface, 0 to 1, `arc` mm along a path of `length` mm.
double presence(const SurfacePath& path, double arc, double length) {
  const double in = path.fadeIn > 0 ? smoothStep(0, path.fadeIn, arc) : 1;
  const double out = path.fadeOut > 0 ? smoothStep(0, path.fadeOut, length - arc) : 1;
  return std::min(in, out);
}

std::vector<AxisPoint> liftedAxis(const ImplicitNode& base, const SurfacePath& path,
                                  const std::vector<Vec3>& dense) {
  std::vector<double> arc(dense.size(), 0.0);
  for (std::size_t i = 1; i < dense.size(); ++i)
    arc[i] = arc[i - 1] + (dense[i] - dense[i - 1]).norm();
  const double length = arc.back();
  std::vector<AxisPoint> axis;
  for (std::size_t i = 0; i < dense.size() && length > 0; ++i) {
    const double present = presence(path, arc[i], length);
    const double full = path.startRadius + arc[i] / length * (path.endRadius - path.startRadius);
    const double radius = full * (kThinnest + present * (1 - kThinnest));
    const double lift = present * path.lift * radius + (1 - present) * kSunk * full;
    const Vec3 lifted = dense[i] + lift * gradient(base, dense[i]).normalized();
    if (axis.empty() || (lifted - axis.back().position).norm() > kClosest)
      axis.push_back({lifted, radius});
  }
  if (axis.size() < 2)
    axis.clear();
  return axis;
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

  return liftedAxis(base, path, dense);
}

} // namespace viscera::sample_organs
