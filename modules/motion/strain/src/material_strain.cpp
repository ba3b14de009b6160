#include "viscera/strain/material_strain.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace viscera::strain {
namespace {

/// Smaller determinants have no inverse that means anything.
constexpr double kLeastDeterminant = 1e-12;

} // namespace

LocalAxes localAxes(const Vec3& radial, const Vec3& towardsBase) {
  LocalAxes axes;
  axes.radial = radial.normalized();
  Vec3 along = towardsBase - towardsBase.dot(axes.radial) * axes.radial;
  // The wall at the tip of the apex looks along the axis: any direction in it is as good.
  if (!(along.norm() > 1e-9 * towardsBase.norm()))
    along = axes.radial.unitOrthogonal();
  axes.longitudinal = along.normalized();
  axes.circumferential = axes.longitudinal.cross(axes.radial);
  return axes;
}

LocalAxes carriedAxes(const LocalAxes& axes, const Eigen::Matrix3d& m) {
  if (!(std::abs(m.determinant()) > kLeastDeterminant))
    return axes;
  return localAxes(m.inverse().transpose() * axes.radial, m * axes.longitudinal);
}

WallStrain strainAlong(const Eigen::Matrix3d& m, const LocalAxes& axes) {
  const Vec3 r = m * axes.radial, c = m * axes.circumferential, l = m * axes.longitudinal;
  WallStrain strain;
  strain.radial = 0.5 * (r.squaredNorm() - 1);
  strain.circumferential = 0.5 * (c.squaredNorm() - 1);
  strain.longitudinal = 0.5 * (l.squaredNorm() - 1);
  strain.circumferentialLongitudinal = 0.5 * c.dot(l);
  strain.circumferentialRadial = 0.5 * c.dot(r);
  strain.longitudinalRadial = 0.5 * l.dot(r);
  return strain;
}

double engineering(double greenLagrange) {
  return std::sqrt(std::max(0.0, 1 + 2 * greenLagrange)) - 1;
}

} // namespace viscera::strain
