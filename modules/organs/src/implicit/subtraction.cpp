#include "implicit/subtraction.h"

#include <algorithm>
#include <utility>

#include "implicit/smooth_blend.h"

namespace viscera::organs {

Subtraction::Subtraction(NodePtr body, std::vector<NodePtr> cuts, double blend)
    : ImplicitNode(body->extent()), body_(std::move(body)), cuts_(std::move(cuts)), blend_(blend) {}

double Subtraction::cut(double distance, const Vec3& point) const {
  for (const NodePtr& other : cuts_) {
    if (other->extent().distance(point) > kDistanceShortfall * (std::max(-distance, 0.0) + blend_))
      continue;
    distance = smoothMax(distance, -other->distance(point), blend_);
  }
  return distance;
}

double Subtraction::distance(const Vec3& point) const {
  return cut(body_->distance(point), point);
}

Shade Subtraction::shadeUnfinished(const Vec3& point) const {
  Shade shade = body_->shade(point);
  shade.distance = cut(shade.distance, point);
  return shade;
}

} // namespace viscera::organs
