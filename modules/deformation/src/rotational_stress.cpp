#include "viscera/deformation/rotational_stress.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace viscera::deformation {
namespace {

/// Below this part of the largest one, the square root of the smallest eigenvalue has lost digits to
/// rounding, and the determinant knows the smallest singular value better.
constexpr double kThin = 1e-3;

/// The unit eigenvector of a symmetric matrix for a simple eigenvalue: orthogonal to the rows of `a - value
/// I`.
Eigen::Vector3d eigenvector(const Eigen::Matrix3d& a, double value) {
  const Eigen::Matrix3d rest = a - value * Eigen::Matrix3d::Identity();
  Eigen::Vector3d best = rest.col(0).cross(rest.col(1));
  for (const Eigen::Vector3d& other :
       {rest.col(1).cross(rest.col(2)).eval(), rest.col(2).cross(rest.col(0)).eval()})
    if (other.squaredNorm() > best.squaredNorm())
      best = other;
  return best.normalized();
}

/// Eigenvalues of a symmetric matrix, descending. The trigonometric solution of the characteristic cubic
/// gives the one that stands apart; the other two, which may nearly coincide, come from the plane across its
/// eigenvector, where nothing cancels.
Eigen::Vector3d symmetricEigenvalues(const Eigen::Matrix3d& a) {
  // A = m I + r B with m = tr A / 3 and r^2 = |A - m I|^2 / 6. With cos(3 phi) = det B / 2 the eigenvalues
  // of B are 2 cos(phi + 2 pi k / 3).
  const double mean = a.trace() / 3;
  const Eigen::Matrix3d deviator = a - mean * Eigen::Matrix3d::Identity();
  const double radius = std::sqrt(deviator.squaredNorm() / 6);
  if (radius == 0)
    return Eigen::Vector3d::Constant(mean);
  const Eigen::Matrix3d unit = deviator / radius;
  const double half = std::clamp(unit.determinant() / 2, -1.0, 1.0);
  const bool highest = half >= 0;
  const double angle = std::acos(half) / 3;
  const Eigen::Vector3d v =
      eigenvector(unit, 2 * std::cos(highest ? angle : angle + 2 * std::numbers::pi / 3));
  const Eigen::Vector3d u = v.unitOrthogonal(), w = v.cross(u);
  const double p = u.dot(unit * u), q = u.dot(unit * w), r = w.dot(unit * w);
  const double middle = (p + r) / 2, spread = std::hypot((p - r) / 2, q);
  const double apart = v.dot(unit * v);
  const Eigen::Vector3d values = highest ? Eigen::Vector3d(apart, middle + spread, middle - spread)
                                         : Eigen::Vector3d(middle + spread, middle - spread, apart);
  return Eigen::Vector3d::Constant(mean) + radius * values;
}

} // namespace

Eigen::Vector3d singularValues(const Eigen::Matrix3d& m) {
  const double scale = m.cwiseAbs().maxCoeff();
  if (scale == 0)
    return Eigen::Vector3d::Zero();
  const Eigen::Matrix3d unit = m / scale; // No overflow in the squares.
  // s_i = sqrt(eigenvalue_i(M^T M)); the smallest of thin tissue from |det M| = s1 s2 s3.
  Eigen::Vector3d values = symmetricEigenvalues(unit.transpose() * unit).cwiseMax(0.0).cwiseSqrt();
  if (values[2] < kThin * values[0] && values[1] > 0)
    values[2] = std::min(values[1], std::abs(unit.determinant()) / (values[0] * values[1]));
  return scale * values;
}

LocalDistortion localDistortion(const Eigen::Matrix3d& m) {
  const Eigen::Vector3d s = singularValues(m);
  LocalDistortion distortion;
  // sigma = arcsin((s1 - s3) / (s1 + s3)) = atan2(s1 - s3, 2 sqrt(s1 s3)).
  // The same as the arcsine, but exact also near a right angle, where its derivative is infinite.
  distortion.rotationalStress = std::atan2(s[0] - s[2], 2 * std::sqrt(s[0] * s[2]));
  distortion.volumeRatio = m.determinant();
  distortion.stretchMax = s[0];
  distortion.stretchMin = s[2];
  return distortion;
}

PrincipalStretches principalStretches(const Eigen::Matrix3d& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m * m.transpose());
  PrincipalStretches result;
  Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
  if (axes.determinant() < 0)
    axes.col(2) = -axes.col(2);
  result.directions = Eigen::Quaterniond(axes).normalized();
  result.stretches = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
  return result;
}

} // namespace viscera::deformation
