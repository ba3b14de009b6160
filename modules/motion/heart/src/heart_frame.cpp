#include "viscera/heart/heart_frame.h"

#include <cmath>

#include <Eigen/Geometry>

#include "viscera/core/error.h"

namespace viscera::heart {
namespace {
/// Below this sine of the angle between the two directions the frame would be a guess.
constexpr double kSmallestSine = 1e-3;
} // namespace

HeartFrame::HeartFrame(const Vec3& origin, const Vec3& towardsRight, const Vec3& towardsApex)
    : origin_(origin) {
  const Vec3 c = towardsApex.normalized();
  const Vec3 across = towardsRight - towardsRight.dot(c) * c;
  if (!origin.allFinite() || towardsApex.isZero(0) || !(across.norm() > kSmallestSine * towardsRight.norm()))
    throw DataError("the directions to the right ventricle and to the apex do not span a frame",
                    "heart frame", "choose landmarks that do not lie on one line");
  axes_.col(0) = across.normalized();
  axes_.col(1) = c.cross(axes_.col(0));
  axes_.col(2) = c;
}

HeartPoint HeartFrame::cylindrical(const Vec3& point) const {
  const Vec3 local = toLocal(point);
  return {std::hypot(local.x(), local.y()), std::atan2(local.y(), local.x()), local.z()};
}

Vec3 HeartFrame::toWorld(const HeartPoint& point) const {
  return toWorld(Vec3(point.rho * std::cos(point.phi), point.rho * std::sin(point.phi), point.c));
}

HeartFrame sampleHeartFrame() {
  return {{-8, 22, 18}, {-0.62, -0.78, 0.05}, {0.64, -0.55, -0.54}};
}

} // namespace viscera::heart
