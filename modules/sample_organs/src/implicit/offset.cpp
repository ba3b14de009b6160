#include "implicit/offset.h"

#include <algorithm>
#include <utility>

namespace viscera::sample_organs {

Offset::Offset(NodePtr child, double distance)
    : ImplicitNode(child->extent().grown(std::max(distance, 0.0))), child_(std::move(child)),
      offset_(distance) {}

Shade Offset::shadeUnfinished(const Vec3& point) const {
  Shade shade = child_->shade(point);
  shade.distance -= offset_;
  return shade;
}

} // namespace viscera::sample_organs
