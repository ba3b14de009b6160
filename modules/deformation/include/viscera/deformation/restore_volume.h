#pragma once

#include <vector>

#include "viscera/deformation/deformer.h"
#include "viscera/deformation/restoration_model.h"

namespace viscera::deformation {

/// The handles that a pose leaves at rest exactly, ascending: free to make up for the volume that the others
/// change.
std::vector<int> restingHandles(const Points& restHandles, const Points& pose);

/// Poses `deformer` so that it encloses `targetMm3` (mm^3): moves the `compensating` handles at the least
/// cost by `model` and leaves the others. The `VolumeLock` for one surface and one pose, without keeping a
/// lock.
///
/// Throws `UsageError` when there is no compensating handle or one that does not exist, `DataError` for an
/// open surface, or when a handle would have to move farther than the diagonal of the handles at rest. The
/// pose is then as it was.
void restoreVolume(Deformer& deformer, double targetMm3, const std::vector<int>& compensating,
                   const RestorationModel& model = LeastDisplacement());

} // namespace viscera::deformation
