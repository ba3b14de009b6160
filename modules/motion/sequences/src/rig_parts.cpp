#include "viscera/sequences/rig_parts.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace viscera::sequences {

std::vector<Vec3> ringAround(const Vec3& center, const Vec3& axis, double radius, int count) {
  const Vec3 along = axis.normalized();
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.cross(u);
  std::vector<Vec3> places;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    const Vec3 around = radius * (std::cos(angle) * u + std::sin(angle) * v);
    places.push_back(center + around);
  }
  return places;
}

std::vector<Vec3> cornersOf(const Bounds& box) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back((k & 1 ? box.high : box.low).x(), (k & 2 ? box.high : box.low).y(),
                         (k & 4 ? box.high : box.low).z());
  return corners;
}

} // namespace viscera::sequences
