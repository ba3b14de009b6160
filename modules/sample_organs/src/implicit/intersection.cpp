#include "implicit/intersection.h"

#include <utility>

#include "implicit/smooth_blend.h"

namespace viscera::sample_organs {
namespace {

Extent intersectionExtent(const std::vector<NodePtr>& children) {
  Extent extent = children.front()->extent();
  for (const NodePtr& child : children)
    extent = extent.intersectedWith(child->extent());
  return extent;
}

} // namespace

Intersection::Intersection(std::vector<NodePtr> children, double blend)
    : ImplicitNode(intersectionExtent(children)), children_(std::move(children)), blend_(blend) {}

double Intersection::cut(double distance, const Vec3& point, double limit) const {
  for (std::size_t i = 1; i < children_.size() && distance < limit; ++i)
    distance = smoothMax(distance, children_[i]->distanceUpTo(point, limit), blend_);
  return distance;
}

double Intersection::distanceUpTo(const Vec3& point, double limit) const {
  return cut(children_.front()->distanceUpTo(point, limit), point, limit);
}

Shade Intersection::shadeUnfinished(const Vec3& point) const {
  Shade shade = children_.front()->shade(point);
  shade.distance = cut(shade.distance, point, kUnlimited);
  return shade;
}

} // namespace viscera::sample_organs
