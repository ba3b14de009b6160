#include "implicit/intersection.h"

#include <utility>

#include "implicit/smooth_blend.h"

namespace viscera::organs {
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

double Intersection::cut(double distance, const Vec3& point) const {
  for (std::size_t i = 1; i < children_.size(); ++i)
    distance = smoothMax(distance, children_[i]->distance(point), blend_);
  return distance;
}

double Intersection::distance(const Vec3& point) const {
  return cut(children_.front()->distance(point), point);
}

Shade Intersection::shadeUnfinished(const Vec3& point) const {
  Shade shade = children_.front()->shade(point);
  shade.distance = cut(shade.distance, point);
  return shade;
}

} // namespace viscera::organs
