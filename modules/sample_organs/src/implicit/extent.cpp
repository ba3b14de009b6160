#include "implicit/extent.h"

namespace viscera::sample_organs {

void Extent::include(const Vec3& point) {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

void Extent::include(const Extent& other) {
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

void Extent::includeBall(const Vec3& point, double radius) {
  include(Vec3(point.array() - radius));
  include(Vec3(point.array() + radius));
}

Extent Extent::grown(double margin) const {
  return {Vec3(low.array() - margin), Vec3(high.array() + margin)};
}

Extent Extent::intersectedWith(const Extent& other) const {
  return {low.cwiseMax(other.low), high.cwiseMin(other.high)};
}

Vec3 Extent::corner(int index) const {
  return {index & 1 ? high.x() : low.x(), index & 2 ? high.y() : low.y(), index & 4 ? high.z() : low.z()};
}

} // namespace viscera::sample_organs
