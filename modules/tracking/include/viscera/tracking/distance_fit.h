#pragma once

#include <functional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/tracking/series_fit.h"
#include "viscera/tracking/surface_distance.h"

namespace viscera::tracking {

/// The targets to which surfaces are fitted in one phase: how far they are from it, surface by surface.
struct PhaseTargets {
  std::vector<std::shared_ptr<const SurfaceDistance>> distances; ///< One a surface.
  Values volumesMl;                                              ///< Measured, one a surface.

  std::size_t bytes() const;
};

/// The options of `fitDistances`.
struct DistanceFitOptions {
  FitOptions fit{1e-5, 1e-4, true};
  double sliding = 0.02;  ///< Part of a step along the wall that counts as much as one away from it.
  int steps = 12;         ///< Of Gauss and Newton at most.
  int smoothingSteps = 4; ///< Of the second sweep, in which a phase is pulled to between its neighbours.
  double stillMm = 0.02;  ///< Done when no vertex moves by more.
  double robustMm = 0;    ///< Beyond it a distance counts as by Huber, not squared; 0: all squared.
  /// The rig is not the first phase's own: it is brought there with bending made cheaper step by step.
  bool foreignRig = false;
};

/// Finds the poses in which a rig's surfaces fit the targets of every phase, without point correspondences:
/// Gauss and Newton on the squared distances of the vertices, phase by phase, each from the one before; then
/// a sweep that pulls each phase to between its neighbours and closes the loop; then the volumes. `targets`
/// makes a phase's distances; it is asked once a phase and sweep, or once where all of them fit into memory.
/// What moves along a wall is not seen. Phases follow one another, the work within one uses several threads;
/// bitwise independent of their number. O(steps x phases x m n^2). Throws `Cancelled`.
MotionFit fitDistances(const MotionRig& rig, const std::function<PhaseTargets(std::size_t phase)>& targets,
                       const PhaseTimes& times, const DistanceFitOptions& options, Progress& progress,
                       Threads threads = {});

} // namespace viscera::tracking
