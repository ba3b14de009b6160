#pragma once

#include <optional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/strain/wall_means.h"

namespace viscera::live {

/// What a fit has left on one surface in one phase.
struct SurfaceResidual {
  const Points* rest = nullptr;     ///< Its vertices with the handles at rest.
  const Points* fitted = nullptr;   ///< Where the fitted pose moves them.
  const Points* measured = nullptr; ///< Where they were measured.
};

/// The root of the mean square of what is left at the vertices nearest to each handle, mm; 0 for handles that
/// are nearest to none. `rest` are the handles at rest, `n x 3`. O(vertices x handles).
Values handleResiduals(const Points& rest, const std::vector<SurfaceResidual>& surfaces, Threads threads);

/// A pose with what its fit has left at each handle.
struct FittedPose {
  const Points* pose = nullptr;
  Values residualMm; ///< One for each handle.
};

/// The standard deviations of the segments' strain from `reference` to `now` when each handle is off by its
/// residual, in any direction and independent of the others. The same for each call; O(points x handles) for
/// each of two dozen draws.
strain::WallMeans drawnDeviations(const strain::WallPoints& points,
                                  const deformation::WitnessGradients& gradients, const FittedPose& reference,
                                  const FittedPose& now, Progress& progress, Threads threads);

} // namespace viscera::live
