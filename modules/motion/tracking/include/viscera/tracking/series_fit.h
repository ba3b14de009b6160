#pragma once

#include <vector>

#include "viscera/core/progress.h"
#include "viscera/tracking/motion_rig.h"
#include "viscera/tracking/phase_times.h"
#include "viscera/tracking/surface_series.h"
#include "viscera/tracking/volume_equality.h"

namespace viscera::tracking {

/// The weights of smoothness and other terms against the mean squared distance of the surfaces, mm^2.
struct FitOptions {
  double bending = 1e-5;   ///< Of the part of a pose that is not an affine motion of the handles.
  double smoothing = 1e-5; ///< Of unevenness in time.
  bool keepVolumes = true; ///< Each phase has its measured volumes, exactly.
};

/// The poses of a rig that were fitted to a series.
struct MotionFit {
  std::vector<Points> poses;           ///< `n x 3` mm, one for each phase.
  std::vector<Values> freeVolumesMl;   ///< Of every surface in every phase before volumes were kept.
  std::vector<VolumeResidual> volumes; ///< One for each phase; empty where they were not kept.
  std::vector<int> steps;              ///< Of Gauss and Newton, one for each phase; 1 for a linear problem.
};

/// Finds the poses that fit the rig's surfaces, bound in the first phase, to `series` (the same surfaces with
/// the same vertices in all phases, one after the other): the minimum of `sum_t |W h_t - x_t|^2 + bending |R
/// (h_t - H)|^2 + smoothing |second differences in time|^2`, which an eigendecomposition of the last term
/// separates into one solve for each eigenvector. Then the volumes (`solveVolumes`) of the closed surfaces.
/// Exact, deterministic. O(phases x m n + phases x n^3).
MotionFit fitSeries(const MotionRig& rig, const std::vector<SurfaceSeries>& series, const PhaseTimes& times,
                    const FitOptions& options, Progress& progress);

} // namespace viscera::tracking
