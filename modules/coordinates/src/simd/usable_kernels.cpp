#include "simd/usable_kernels.h"

#include "viscera/coordinates/vector_bits.h"

namespace viscera::coordinates::simd {

#if defined(__x86_64__)
namespace {

template <class Kernels>
std::vector<const Kernels*> usable(const Kernels& avx512, const Kernels& avx2, const Kernels& baseline) {
  std::vector<const Kernels*> usable;
  if (vectorBits() >= 512)
    usable.push_back(&avx512);
  if (vectorBits() >= 256)
    usable.push_back(&avx2);
  usable.push_back(&baseline);
  return usable;
}

} // namespace

std::vector<const CelestialKernels*> usableCelestialKernels() {
  return usable(avx512::kCelestialKernels, avx2::kCelestialKernels, baseline::kCelestialKernels);
}

std::vector<const DeterminantKernels*> usableDeterminantKernels() {
  return usable(avx512::kDeterminantKernels, avx2::kDeterminantKernels, baseline::kDeterminantKernels);
}

std::vector<const TileKernels*> usableTileKernels() {
  return usable(avx512::kTileKernels, avx2::kTileKernels, baseline::kTileKernels);
}
#else
// The faster ones are not compiled.
std::vector<const CelestialKernels*> usableCelestialKernels() {
  return {&baseline::kCelestialKernels};
}

std::vector<const DeterminantKernels*> usableDeterminantKernels() {
  return {&baseline::kDeterminantKernels};
}

std::vector<const TileKernels*> usableTileKernels() {
  return {&baseline::kTileKernels};
}
#endif

const DeterminantKernels& determinantKernels() {
  static const DeterminantKernels& fastest = *usableDeterminantKernels().front();
  return fastest;
}

const TileKernels& tileKernels() {
  static const TileKernels& fastest = *usableTileKernels().front();
  return fastest;
}

} // namespace viscera::coordinates::simd
