#include "implicit/subtraction.h"

#include <algorithm>
#include <utility>

#include "implicit/smooth_blend.h"

namespace viscera::sample_organs {

Subtraction::Subtraction(NodePtr body, std::vector<NodePtr> cuts, double blend)
    : ImplicitNode(body->extent()), body_(std::move(body)), cuts_(std::move(cuts)), blend_(blend) {}

double Subtraction::cut(double distance, const Vec3& point) const {
  for (const NodePtr& other : cuts_) {
    const double reach = std::max(-distance, 0.0) + blend_;
    if (other->extent().distance(point) > kDistanceShortfall * reach)
      continue;
    distance = smoothMax(distance, -other->distanceUpTo(point, reach), blend_);
  }
  return distance;
}

double Subtraction::distanceUpTo(const Vec3& point, double limit) const {
  const double ofBody = body_->distanceUpTo(point, limit);
  return ofBody < limit ? cut(ofBody, point) : ofBody;
}

Shade Subtraction::shadeUnfinished(const Vec3& point) const {
  Shade shade = body_->shade(point);
  shade.distance = cut(shade.distance, point);
  return shade;
}

} // namespace viscera::sample_organs
