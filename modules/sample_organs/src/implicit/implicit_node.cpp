#include "implicit/implicit_node.h"

#include <algorithm>

#include "implicit/smooth_functions.h"

namespace viscera::sample_organs {
namespace {
constexpr double kDifferenceStep = 0.05;     // mm; the finest detail of a definition is ten times wider
constexpr double kLongestNodeStep = 3.0;     // mm; distances are only trusted near the surface
constexpr double kSmallestNodeSlope2 = 0.05; // squared; keeps steps finite where blends flatten the field
constexpr int kMottleSeed = 7;
constexpr double kOnSurface = 1e-4; // mm
} // namespace

Shade ImplicitNode::shade(const Vec3& point) const {
  Shade shade = shadeUnfinished(point);
  if (finish_.paint)
    shade.color = *finish_.paint;
  if (finish_.edgeScale)
    shade.edgeScale = *finish_.edgeScale;
  if (finish_.mottle) {
    const Vec3 scaled = point / finish_.mottle->wavelength;
    const double noise =
        0.67 * valueNoise(scaled, kMottleSeed) + 0.33 * valueNoise(2.03 * scaled, kMottleSeed);
    shade.color *= 1 + finish_.mottle->amount * noise;
  }
  return shade;
}

Vec3 gradient(const ImplicitNode& node, const Vec3& point) {
  Vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = kDifferenceStep * Vec3::Unit(axis);
    slope[axis] = (node.distance(point + step) - node.distance(point - step)) / (2 * kDifferenceStep);
  }
  return slope;
}

Vec3 projected(const ImplicitNode& node, Vec3 point, int steps) {
  for (int step = 0; step < steps; ++step) {
    const double distance = node.distance(point);
    if (std::abs(distance) < kOnSurface)
      break;
    const Vec3 slope = gradient(node, point);
    // Newton for d = 0 along the gradient, -d grad d / |grad d|^2.
    Vec3 move = -distance / std::max(slope.squaredNorm(), kSmallestNodeSlope2) * slope;
    const double length = move.norm();
    if (length > kLongestNodeStep)
      move *= kLongestNodeStep / length;
    point += move;
  }
  return point;
}

} // namespace viscera::sample_organs
