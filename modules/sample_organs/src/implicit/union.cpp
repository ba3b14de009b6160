#include "implicit/union.h"

#include <algorithm>
#include <utility>

#include "implicit/smooth_blend.h"

namespace viscera::sample_organs {
namespace {

constexpr double kNarrowestSeam = 0.5; // mm; a colour step sharper than this only shows the triangles

Extent unionExtent(const std::vector<NodePtr>& children, double blend) {
  Extent extent;
  for (const NodePtr& child : children)
    extent.include(child->extent());
  return extent.grown(0.25 * blend);
}

} // namespace

Union::Union(std::vector<NodePtr> children, double blend)
    : ImplicitNode(unionExtent(children, blend)), children_(std::move(children)), blend_(blend) {}

bool Union::cannotMatter(const ImplicitNode& child, const Vec3& point, double distance) const {
  return child.extent().distance(point) >
         kDistanceShortfall * (std::max(distance, 0.0) + blend_ + kNarrowestSeam);
}

double Union::distanceUpTo(const Vec3& point, double limit) const {
  double result = kUnlimited;
  for (const NodePtr& child : children_) {
    const double least = std::min(result, limit);
    if (cannotMatter(*child, point, least))
      continue;
    result = smoothMin(result, child->distanceUpTo(point, least + blend_), blend_);
  }
  return result;
}

Shade Union::shadeUnfinished(const Vec3& point) const {
  const double seam = std::max(0.6 * blend_, kNarrowestSeam);
  Shade result{kUnlimited};
  bool first = true;
  for (const NodePtr& child : children_) {
    if (cannotMatter(*child, point, result.distance))
      continue;
    const Shade other = child->shade(point);
    const double share = first ? 1.0 : smoothStep(-seam, seam, result.distance - other.distance);
    result.color += share * (other.color - result.color);
    result.edgeScale += share * (other.edgeScale - result.edgeScale);
    result.distance = smoothMin(result.distance, other.distance, blend_);
    first = false;
  }
  return result;
}

} // namespace viscera::sample_organs
