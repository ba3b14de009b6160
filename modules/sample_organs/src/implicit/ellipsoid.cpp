#include "implicit/ellipsoid.h"

namespace viscera::sample_organs {
namespace {

Extent extentOf(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes) {
  const Vec3 half = (axes * radii.asDiagonal()).rowwise().norm();
  Extent extent;
  extent.include(Vec3(center - half));
  extent.include(Vec3(center + half));
  return extent;
}

} // namespace

Ellipsoid::Ellipsoid(const Vec3& center, const Vec3& radii, const Eigen::Matrix3d& axes)
    : ImplicitNode(extentOf(center, radii, axes)), center_(center), radii_(radii), toAxes_(axes.transpose()) {
}

double Ellipsoid::distanceUpTo(const Vec3& point, double /*limit*/) const {
  const Vec3 scaled = (toAxes_ * (point - center_)).cwiseQuotient(radii_);
  const double level = scaled.norm();
  const double slope = scaled.cwiseQuotient(radii_).norm();
  // At the centre the quotient below is 0 / 0; its limit along the shortest axis is the honest answer.
  if (level < 1e-9)
    return -radii_.minCoeff();
  return level * (level - 1) / slope;
}

} // namespace viscera::sample_organs
