#pragma once

#include <memory>

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates of one closed, outward surface over some of the handles.
std::unique_ptr<const PointSolver> meanValueSolver(Points handles, Triangles cage);

} // namespace viscera::coordinates
