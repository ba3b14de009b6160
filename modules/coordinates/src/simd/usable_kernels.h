#pragma once

#include <vector>

#include "celestial/celestial_kernels.h"
#include "simd/determinant_kernels.h"
#include "simd/tile_kernels.h"

/// Those versions of the kernels that can run here (`vectorBits`), the fastest first.
namespace viscera::coordinates::simd {

std::vector<const CelestialKernels*> usableCelestialKernels();
std::vector<const DeterminantKernels*> usableDeterminantKernels();
std::vector<const TileKernels*> usableTileKernels();
/// The first of them.
const DeterminantKernels& determinantKernels();
const TileKernels& tileKernels();

} // namespace viscera::coordinates::simd
