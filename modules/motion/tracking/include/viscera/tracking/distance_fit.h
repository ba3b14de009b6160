#pragma once

#include <functional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/tracking/series_fit.h"
#include "viscera/tracking/surface_distance.h"

namespace viscera::tracking {

/// The targets to which surfaces are fitted in one phase: a distance function and a volume for each surface.
struct PhaseTargets {
  std::vector<std::shared_ptr<const SurfaceDistance>> distances; ///< One for each surface.
  Values volumesMl;                                              ///< Measured, one for each surface.
  /// Closed lines (`n x 3` mm) where the rig's rims are in this phase; one for each of
  /// `DistanceFitOptions::rims`.
  std::vector<Points> rims = {};

  std::size_t bytes() const;
};

/// A rim of one of a rig's surfaces.
struct RimRows {
  std::size_t surface = 0;
  std::vector<Eigen::Index> rows; ///< Of `MotionRig::weights`, in their order along the rim.
};

/// The options of `fitDistances`.
struct DistanceFitOptions {
  FitOptions fit{1e-5, 1e-4, true};
  double sliding = 0.02;  ///< Part of a step along the wall that counts as much as one away from it.
  int steps = 12;         ///< Of Gauss and Newton at most.
  int smoothingSteps = 4; ///< Of the second sweep, in which a phase is pulled to between its neighbours.
  double stillMm = 0.02;  ///< Done when no vertex moves by more.
  /// Lines on the surfaces that are seen in every phase, the rims of valves: they stay upon those of the
  /// targets, and may slide along them.
  std::vector<RimRows> rims = {};
  /// A rim counts as much as a band of its surface of this width, mm; 0: the median distance between handles,
  /// which move no narrower one by itself.
  double rimMm = 0;
  double robustMm = 0; ///< Larger distances count linearly (Huber) instead of squared; 0: all squared.
  /// The rig was not made for the first phase: it is fitted to that phase with a bending cost that decreases
  /// step by step.
  bool foreignRig = false;
};

/// Finds the poses in which a rig's surfaces fit the targets of every phase, without point correspondences:
/// Gauss and Newton on the squared distances of the vertices, phase by phase, each from the one before; then
/// a sweep that pulls each phase to between its neighbours and closes the loop; then the volumes. `targets`
/// makes a phase's distances; it is called once for each phase and sweep, or once if all of them fit into
/// memory. Motion along a wall cannot be detected, but where a rim ends the wall. Phases follow one another,
/// the work within one uses several threads; bitwise independent of their number. O(steps x phases x m n^2).
/// Throws `Cancelled`.
MotionFit fitDistances(const MotionRig& rig, const std::function<PhaseTargets(std::size_t phase)>& targets,
                       const PhaseTimes& times, const DistanceFitOptions& options, Progress& progress,
                       Threads threads = {});

} // namespace viscera::tracking
