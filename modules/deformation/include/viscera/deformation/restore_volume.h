#pragma once

#include <vector>

#include "viscera/deformation/deformer.h"

namespace viscera::deformation {

/// The handles that a pose leaves at rest exactly, ascending: free to make up for the volume that the others
/// change.
std::vector<int> restingHandles(const Points& restHandles, const Points& pose);

/// Poses `deformer` so that it encloses `targetMm3` (mm^3): moves the `compensating` handles from where they
/// are along the volume's own gradient, the shortest way that the gradient knows, and leaves the others.
///
/// Along a straight motion of all handles the volume is a cubic polynomial, because every vertex moves
/// straight too (thesis 5.1: the integrand is a product of three positions). Four volumes give that cubic
/// exactly, and its root of smallest size is taken; so this is one step and no iteration. The thesis locks
/// single handles only.
///
/// Costs a gradient and six poses. Throws `UsageError` when there is no compensating handle or one that does
/// not exist, `DataError` for an open surface's target that no sensible motion reaches: a handle would have
/// to move farther than the diagonal of the handles at rest, or the volume does not depend on these handles.
/// The pose is then as it was.
void restoreVolume(Deformer& deformer, double targetMm3, const std::vector<int>& compensating);

} // namespace viscera::deformation
