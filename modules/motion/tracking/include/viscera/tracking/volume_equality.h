#pragma once

#include <functional>

#include "viscera/tracking/motion_rig.h"

/// Corrects a fitted pose so that every surface has its measured volume.
namespace viscera::tracking {

/// Solves with the normal matrix of a fit: given the derivative of a quantity with respect to every handle
/// (`n x 3`), returns the displacement (`n x 3`) that increases it at the least cost of the fit.
using Metric = std::function<Points(const Points& gradient)>;

/// The remaining errors of the volumes.
struct VolumeResidual {
  Values missingMl; ///< Of every surface: wanted less actual volume, after the last step.
  int steps = 0;
  bool met = false; ///< All to 1e-6 ml or 1e-9 of the volume.
};

/// Moves `pose` (`n x 3` mm) so that every surface of the rig has the volume wanted, ml: Newton's method on
/// all equalities at once along the metric's directions, which cost the fit least. 3 steps reach 1e-6 ml; at
/// most 12 are done. Deterministic. O(steps x surfaces x m n).
VolumeResidual solveVolumes(const MotionRig& rig, const Values& wantedMl, const Metric& metric, Points& pose);

} // namespace viscera::tracking
