#pragma once

#include <cstddef>

#include "viscera/deformation/witness_mesh.h"
#include "viscera/tracking/motion_rig.h"

namespace viscera::tracking {

/// The points of `TissueWitnesses`; throws the same.
deformation::WitnessMesh tissueWitnesses(const MotionRig& rig, std::size_t outer, int wanted,
                                         Progress& progress, Threads threads);

} // namespace viscera::tracking
