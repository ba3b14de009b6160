#pragma once

#include <array>

#include "viscera/tracking/motion_rig.h"

namespace viscera::tracking {

/// How much a change of a rig's pose strains the tissue: at witness points 7 mm apart in the tissue between
/// an outer surface and its cavities, and within 8 mm of every surface. Immutable; thread-safe.
class WallStiffness {
public:
  /// Throws what binding throws, `Cancelled`. O(points x handles^2).
  WallStiffness(const MotionRig& rig, std::size_t outer, Progress& progress, Threads threads);

  /// Mean square of the displacement's gradient without its affine part, `n x n` for each axis.
  const Eigen::MatrixXd& strain() const { return strain_; }
  /// Mean square of the change of that gradient between neighbouring points.
  const Eigen::MatrixXd& bending() const { return bending_; }

  Eigen::Index points() const { return rows_[0].rows(); } ///< Where folds are looked for.
  /// det F there at a pose. O(points x handles).
  Values ratios(const Points& pose) const;
  /// The derivative of det F at one point by every handle, `n x 3`.
  Points ratioGradient(const Points& pose, Eigen::Index point) const;

private:
  std::array<Eigen::MatrixXd, 3> rows_; ///< Derivatives of the weights along x, y and z, `points x n`.
  Eigen::MatrixXd strain_, bending_;
};

} // namespace viscera::tracking
