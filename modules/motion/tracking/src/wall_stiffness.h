#pragma once

#include <array>

#include "viscera/tracking/motion_rig.h"

namespace viscera::tracking {

/// How much a change of a rig's pose strains the tissue: at witness points 7 mm apart in the tissue between
/// an outer surface and its cavities, and within 8 mm of every surface. Immutable; thread-safe.
class WallStiffness {
public:
  /// `witnesses`: of the points in the outer surface and no cavity, those of `TissueWitnesses`, where folds
  /// are counted; 0: none. Throws what binding throws, `Cancelled`. O(points x handles^2).
  WallStiffness(const MotionRig& rig, std::size_t outer, int witnesses, Progress& progress, Threads threads);

  /// Mean square of the displacement's gradient without its affine part, `n x n` for each axis.
  const Eigen::MatrixXd& strain() const { return strain_; }
  /// Mean square of the change of that gradient between neighbouring points.
  const Eigen::MatrixXd& bending() const { return bending_; }

  Eigen::Index points() const { return rows_[0].rows(); } ///< Where folds are looked for.
  /// det F there at a pose. O(points x handles).
  Values ratios(const Points& pose) const { return ratiosOf(rows_, pose); }
  /// The derivative of det F at one point by every handle, `n x 3`.
  Points ratioGradient(const Points& pose, Eigen::Index point) const { return slopeOf(rows_, pose, point); }
  /// The same at the points where folds are counted.
  Values witnessRatios(const Points& pose) const { return ratiosOf(witnesses_, pose); }
  Points witnessGradient(const Points& pose, Eigen::Index witness) const {
    return slopeOf(witnesses_, pose, witness);
  }

private:
  /// Derivatives of the weights along x, y and z, `points x n`.
  using Rows = std::array<Eigen::MatrixXd, 3>;

  static Values ratiosOf(const Rows& rows, const Points& pose);
  static Points slopeOf(const Rows& rows, const Points& pose, Eigen::Index point);

  Rows rows_, witnesses_;
  Eigen::MatrixXd strain_, bending_;
};

} // namespace viscera::tracking
