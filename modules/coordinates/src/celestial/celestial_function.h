#pragma once

#include <vector>

#include "celestial/celestial_kernels.h"

namespace viscera::coordinates {

/// What tells one celestial system from another.
struct CelestialFunction {
  double (*first)(double t);  ///< phi'.
  double (*second)(double t); ///< phi''.
  simd::SolveCelestialTile solve2;
  simd::SolveCelestialTile solve3;
};

/// All versions of the kernels that can run on this processor, the fastest first.
std::vector<const simd::CelestialKernels*> usableCelestialKernels();

} // namespace viscera::coordinates
