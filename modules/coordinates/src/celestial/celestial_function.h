#pragma once

#include "simd/usable_kernels.h"
#include "viscera/coordinates/celestial/celestial_solution.h"
#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

/// The convex function phi of one celestial system (S or T): its derivatives, and the kernels that find the
/// minimum from which the coordinates follow.
struct CelestialFunction {
  double (*first)(double t);  ///< phi'.
  double (*second)(double t); ///< phi''.
  simd::SolveCelestialTile solve2;
  simd::SolveCelestialTile solve3;
};

/// The derivatives of the coordinates in `solution`. Points at a handle join the failures when there is no
/// softness.
CoordinateGradients celestialGradients(const CelestialFunction& function, const Points& handles,
                                       const Points& points, const CelestialOptions& options,
                                       CelestialSolution<3>& solution);

} // namespace viscera::coordinates
