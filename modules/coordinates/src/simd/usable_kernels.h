#pragma once

#include <vector>

#include "celestial/celestial_kernels.h"
#include "simd/determinant_kernels.h"
#include "simd/tile_kernels.h"

/// Lists the versions of the kernels that can run on this processor (`vectorBits`), the fastest first.
namespace viscera::coordinates::simd {

std::vector<const CelestialKernels*> usableCelestialKernels();
std::vector<const DeterminantKernels*> usableDeterminantKernels();
std::vector<const TileKernels*> usableTileKernels();
/// The fastest version.
const DeterminantKernels& determinantKernels();
const TileKernels& tileKernels();

} // namespace viscera::coordinates::simd
