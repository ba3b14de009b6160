#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "viscera/core/arrays.h"

namespace viscera::tests {

/// A smooth displacement of points, `rms` mm: waves of 25 mm and more.
inline Points smoothError(const Points& points, double rms, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Points error = Points::Zero(points.rows(), 3);
  for (int wave = 0; wave < 12; ++wave) {
    const Vec3 way(any(random), any(random), any(random)), along(any(random), any(random), any(random));
    const double begin = std::numbers::pi * any(random);
    for (Eigen::Index v = 0; v < points.rows(); ++v)
      error.row(v) += std::sin(0.25 * along.dot(points.row(v).transpose()) + begin) * way.transpose();
  }
  return error * (rms / std::sqrt(error.rowwise().squaredNorm().mean()));
}

} // namespace viscera::tests
