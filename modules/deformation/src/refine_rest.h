#pragma once

#include "rest_field.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/inverse_map.h"

namespace viscera::deformation {

/// Implements `InverseMap::refinePlane` on the field of the map.
void refineRest(const RestField& field, const coordinates::CoordinateSystem& system, const SamplePlane& plane,
                const Refinement& refinement, RestPoints& rest, Progress& progress);

} // namespace viscera::deformation
