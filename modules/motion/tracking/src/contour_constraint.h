#pragma once

#include <vector>

#include "viscera/tracking/cine_correction.h"
#include "viscera/tracking/motion_rig.h"

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

} // namespace viscera::tracking
