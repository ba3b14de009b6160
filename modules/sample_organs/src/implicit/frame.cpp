#include "implicit/frame.h"

#include <utility>

namespace viscera::sample_organs {
namespace {

Vec3 placed(const Placement& at, const Vec3& local) {
  return at.origin + at.rotation * (at.scale * local.cwiseProduct(at.mirror));
}

Extent placedExtent(const Extent& local, const Placement& at) {
  Extent extent;
  for (int i = 0; i < 8; ++i)
    extent.include(placed(at, local.corner(i)));
  return extent;
}

} // namespace

Frame::Frame(NodePtr child, const Placement& placement)
    : ImplicitNode(placedExtent(child->extent(), placement)), child_(std::move(child)),
      placement_(placement) {}

Vec3 Frame::local(const Vec3& point) const {
  const Vec3 turned = placement_.rotation.transpose() * (point - placement_.origin);
  return turned.cwiseProduct(placement_.mirror) / placement_.scale;
}

double Frame::distanceUpTo(const Vec3& point, double limit) const {
  return placement_.scale * child_->distanceUpTo(local(point), limit / placement_.scale);
}

Shade Frame::shadeUnfinished(const Vec3& point) const {
  Shade shade = child_->shade(local(point));
  shade.distance *= placement_.scale;
  return shade;
}

} // namespace viscera::sample_organs
