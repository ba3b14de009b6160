#pragma once

#include <cmath>
#include <random>

#include "viscera/core/arrays.h"

/// Makes seeded random points for tests.
namespace viscera::tests {

/// A place whose coordinates are drawn one after the other: compilers evaluate a function's arguments in
/// orders of their own, but what stands in braces in its order.
template <class Distribution>
Vec3 drawPlace(Distribution& coordinate, std::mt19937& random) {
  return Vec3{coordinate(random), coordinate(random), coordinate(random)};
}

/// A unit vector; all directions are as likely.
inline Vec3 drawDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return drawPlace(normal, random).normalized();
}

/// `count` points in the cube [-half, half]^3 around `center`.
inline Points cloud(int count, unsigned seed, double half = 1, const Vec3& center = Vec3::Zero()) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-half, half);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      points(i, axis) = center[axis] + coordinate(random);
  return points;
}

/// `count` points spread over a sphere by the golden angle, none of them inside the others' hull.
inline Points onSphere(int count, double radius = 1, const Vec3& center = Vec3::Zero()) {
  const double golden = M_PI * (3 - std::sqrt(5.0));
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    points.row(i) =
        (center + radius * Vec3(r * std::cos(golden * i), r * std::sin(golden * i), z)).transpose();
  }
  return points;
}

/// A turn of `angle` (rad) around a fixed skew axis.
inline Eigen::Matrix3d turn(double angle) {
  const Vec3 axis = Vec3(1, 2, -3).normalized();
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  return axis * axis.transpose() + std::cos(angle) * (x * x.transpose() + y * y.transpose()) +
         std::sin(angle) * (y * x.transpose() - x * y.transpose());
}

} // namespace viscera::tests
