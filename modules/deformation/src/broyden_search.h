#pragma once

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "viscera/core/arrays.h"

namespace viscera::deformation {

/// Searches the point that a motion moves to `target`, by Broyden's iteration (Broyden 1965, doi
/// 10.1090/S0025-5718-1965-0198670-6). `derivative` may start with an estimate of the motion's derivative.
struct BroydenSearch {
  /// The smallest determinant of the estimated derivative; below it the search fails.
  static constexpr double kSmallestDeterminant = 0.05;

  Eigen::Index row = 0; ///< A number for use by the caller.
  Vec3 target, at, step = Vec3::Zero(), residual = Vec3::Zero();
  Eigen::Matrix3d derivative = Eigen::Matrix3d::Identity();
  Vec3 best = Vec3::Zero();
  double bestError = std::numeric_limits<double>::infinity();
  bool started = false;

  /// Takes the displacement at `at` and moves to the next place; false when it is near enough, or has failed.
  bool advance(const Vec3& displacement, double accuracy) {
    const Vec3 left = at + displacement - target;
    if (!left.allFinite())
      return false;
    if (left.norm() < bestError) {
      bestError = left.norm();
      best = at;
    }
    if (bestError <= accuracy)
      return false;
    // J = J + (dr - J s) s^T / |s|^2 is the least change with which J s is the change dr of the residual that
    // was seen; then s = -J^-1 r.
    if (started && step.squaredNorm() > 0)
      derivative += (left - residual - derivative * step) * step.transpose() / step.squaredNorm();
    if (std::abs(derivative.determinant()) < kSmallestDeterminant)
      derivative.setIdentity();
    step = -derivative.inverse() * left;
    residual = left;
    at += step;
    started = true;
    return true;
  }
};

} // namespace viscera::deformation
