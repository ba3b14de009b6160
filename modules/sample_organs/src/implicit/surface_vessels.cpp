#include "implicit/surface_vessels.h"

#include <algorithm>
#include <utility>

#include "implicit/smooth_blend.h"

namespace viscera::sample_organs {
namespace {

Extent extentOf(const NodePtr& base, const std::vector<SurfaceVessel>& vessels, double blend) {
  Extent extent = base->extent();
  for (const SurfaceVessel& vessel : vessels)
    extent.include(vessel.node->extent());
  return extent.grown(0.25 * blend);
}

} // namespace

SurfaceVessels::SurfaceVessels(NodePtr base, std::vector<SurfaceVessel> vessels, double blend)
    : ImplicitNode(extentOf(base, vessels, blend)), base_(std::move(base)), vessels_(std::move(vessels)),
      blend_(blend) {}

bool SurfaceVessels::cannotMatter(const SurfaceVessel& vessel, const Vec3& point, double distance) const {
  return vessel.node->extent().distance(point) > std::max(distance, 0.0) + blend_ + vessel.seam;
}

double SurfaceVessels::distanceUpTo(const Vec3& point, double limit) const {
  double result = base_->distanceUpTo(point, limit + blend_);
  for (const SurfaceVessel& vessel : vessels_) {
    const double least = std::min(result, limit);
    if (!cannotMatter(vessel, point, least))
      result = smoothMin(result, vessel.node->distanceUpTo(point, least + blend_), blend_);
  }
  return result;
}

Shade SurfaceVessels::shadeUnfinished(const Vec3& point) const {
  Shade result = base_->shade(point);
  for (const SurfaceVessel& vessel : vessels_) {
    if (cannotMatter(vessel, point, result.distance))
      continue;
    const Shade other = vessel.node->shade(point);
    const double share = smoothStep(-vessel.seam, vessel.seam, result.distance - other.distance);
    result.color += share * (other.color - result.color);
    result.edgeScale += share * (other.edgeScale - result.edgeScale);
    result.distance = smoothMin(result.distance, other.distance, blend_);
  }
  return result;
}

} // namespace viscera::sample_organs
