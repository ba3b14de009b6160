#include "breathing_field.h"

#include <algorithm>

#include <Eigen/LU>

namespace viscera::phantom {
namespace {

constexpr double kSolvedMm = 1e-9;
constexpr int kMostNewtonSteps = 30;

/// The part of the diaphragm's motion at a height, and its derivative, 1/mm.
struct Weight {
  double value = 0, slope = 0;
};

/// Heights in the frame of the sample heart, mm, and the part between them.
constexpr double kWholeZ = -150, kHeartLowZ = -45, kHeartHighZ = 90, kStillZ = 175;
constexpr double kHeartShare = 0.65;

/// A cubic from `before` to `after`, without kinks at its ends.
Weight stepBetween(double z, double from, double to, double before, double after) {
  const double t = std::clamp((z - from) / (to - from), 0.0, 1.0);
  return {before + (after - before) * t * t * (3 - 2 * t), (after - before) * 6 * t * (1 - t) / (to - from)};
}

Weight weightAt(double z) {
  return z < kHeartHighZ ? stepBetween(z, kWholeZ, kHeartLowZ, 1, kHeartShare)
                         : stepBetween(z, kHeartHighZ, kStillZ, kHeartShare, 0);
}

/// The sequence of breathing wants handles; only the map of points is used here.
Points cornersOf(const Bounds& box) {
  Points corners(8, 3);
  for (int c = 0; c < 8; ++c)
    corners.row(c) << ((c & 1) != 0 ? box.high : box.low).x(), ((c & 2) != 0 ? box.high : box.low).y(),
        ((c & 4) != 0 ? box.high : box.low).z();
  return corners;
}

} // namespace

BreathingField::BreathingField(const Bounds& liver) : liver_(cornersOf(liver), liver, {}, {.domeShare = 0}) {}

Vec3 BreathingField::moved(const Vec3& rest, double inspiration) const {
  return rest + weightAt(rest.z()).value * (liver_.moved(rest, inspiration) - rest);
}

Vec3 BreathingField::restOf(const Vec3& moved, double inspiration) const {
  // The liver's map is affine: differences are its derivative.
  const Vec3 origin = liver_.moved(Vec3::Zero(), inspiration);
  Eigen::Matrix3d linear;
  for (int axis = 0; axis < 3; ++axis)
    linear.col(axis) = liver_.moved(Vec3::Unit(axis), inspiration) - origin - Vec3::Unit(axis);
  Vec3 rest = moved;
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    // Newton step for r(x) = x + w(z) (L(x) - x) - y = 0.
    const Weight weight = weightAt(rest.z());
    const Vec3 shift = origin + linear * rest;
    const Vec3 residual = rest + weight.value * shift - moved;
    if (residual.norm() <= kSolvedMm)
      break;
    Eigen::Matrix3d derivative = Eigen::Matrix3d::Identity() + weight.value * linear;
    derivative.col(2) += weight.slope * shift;
    rest -= derivative.inverse() * residual;
  }
  return rest;
}

} // namespace viscera::phantom
