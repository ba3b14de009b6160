#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "viscera/tracking/cine_correction.h"
#include "viscera/tracking/motion_rig.h"
#include "viscera/tracking/volume_equality.h"
#include "wall_stiffness.h"

namespace viscera::tracking {

/// Linear equations that the handles of a pose satisfy to first order, x, y and z of all handles below each
/// other.
struct HandleEquations {
  Eigen::MatrixXd rows; ///< `k x 3n`.
  Values wanted;        ///< `k`, mm.
};

/// Corrected contours of one phase as equations for the handles. Keeps the references.
class ContourConstraint {
public:
  ContourConstraint(const MotionRig& rig, std::vector<const CorrectedContour*> contours)
      : rig_(rig), contours_(std::move(contours)) {}

  /// Each point's distance from the surface along its normal, as one within the plane.
  HandleEquations at(const Points& pose) const;
  /// The largest distance of a contour's points from the surface's cut by its plane, mm; from the surface
  /// itself where the plane does not cut it.
  static double mostMm(const MotionRig& rig, const CorrectedContour& contour, const Points& pose);
  double mostMm(const Points& pose) const;

private:
  const MotionRig& rig_;
  std::vector<const CorrectedContour*> contours_;
};

/// What became of a pose that was to meet contours.
struct ContoursMet {
  VolumeResidual volumes;
  bool heldBack = false; ///< Nearer to them, tissue would have folded.
};

/// Finds poses that meet corrected contours and change a pose least. Keeps the references.
class ContourMeeting {
public:
  /// `cost`: of a change of the handles, the same along x, y and z (`n x n`), positive definite.
  ContourMeeting(const MotionRig& rig, const WallStiffness& stiffness, const Eigen::MatrixXd& cost)
      : rig_(rig), stiffness_(stiffness), cost_(cost) {}

  /// Changes `pose` so that the contours are met, or as nearly as the handles can without folded tissue.
  /// Volumes of the surfaces are what `within` makes of them; it may be empty. O(points x handles^2).
  ContoursMet meet(const ContourConstraint& contours, const std::function<Values(const Values&)>& within,
                   Points& pose) const;

private:
  /// The changes that cost least for these derivatives, `3n x k`.
  Eigen::MatrixXd answer(const Eigen::MatrixXd& derivatives) const;
  /// One that meets the contours as loosely as `damping` says.
  VolumeResidual bend(const ContourConstraint& contours, double damping,
                      const std::function<Values(const Values&)>& within, const Points& start,
                      Points& bent) const;

  const MotionRig& rig_;
  const WallStiffness& stiffness_;
  Eigen::LLT<Eigen::MatrixXd> cost_;
};

} // namespace viscera::tracking
