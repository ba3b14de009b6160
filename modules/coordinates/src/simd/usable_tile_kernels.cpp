#include "simd/usable_tile_kernels.h"

#include "simd/usable_kernels.h"

namespace viscera::coordinates::simd {

std::vector<const TileKernels*> usableTileKernels() {
  return VISCERA_USABLE_KERNELS(kTileKernels);
}

const TileKernels& tileKernels() {
  static const TileKernels& fastest = *usableTileKernels().front();
  return fastest;
}

} // namespace viscera::coordinates::simd
