#pragma once

#include "viscera/coordinates/handle_checks.h"
#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// Mean value coordinates of a point in the polygon of the handles; false where they are not defined.
bool planarMeanValue(const PointsOf<2>& handles, const Eigen::Vector2d& point, Values& weights);

} // namespace viscera::coordinates
