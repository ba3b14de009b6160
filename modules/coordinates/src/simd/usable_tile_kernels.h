#pragma once

#include <vector>

#include "simd/tile_kernels.h"

namespace viscera::coordinates::simd {

/// All versions that can run on this processor, the fastest first.
std::vector<const TileKernels*> usableTileKernels();

/// The first of them.
const TileKernels& tileKernels();

} // namespace viscera::coordinates::simd
