#pragma once

#include "viscera/coordinates/celestial/celestial_system.h"

namespace viscera::coordinates {

/// The derivatives of the coordinates in `solution`. Points at a handle join the failures when there is no
/// softness.
CoordinateGradients celestialGradients(const CelestialFunction& function, const Points& handles,
                                       const Points& points, const CelestialOptions& options,
                                       CelestialSolution<3>& solution);

} // namespace viscera::coordinates
