#include "simd/usable_kernels.h"

namespace viscera::coordinates::simd {

#if defined(__x86_64__)
namespace {

template <class Kernels>
std::vector<const Kernels*> usable(const Kernels& avx512, const Kernels& avx2, const Kernels& baseline) {
  std::vector<const Kernels*> usable;
  const bool runsAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool runsAvx512 = runsAvx2 && __builtin_cpu_supports("avx512f") &&
                          __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512bw");
  if (runsAvx512)
    usable.push_back(&avx512);
  if (runsAvx2)
    usable.push_back(&avx2);
  usable.push_back(&baseline);
  return usable;
}

} // namespace

std::vector<const CelestialKernels*> usableCelestialKernels() {
  return usable(avx512::kCelestialKernels, avx2::kCelestialKernels, baseline::kCelestialKernels);
}

std::vector<const TileKernels*> usableTileKernels() {
  return usable(avx512::kTileKernels, avx2::kTileKernels, baseline::kTileKernels);
}
#else
// The faster ones are not compiled.
std::vector<const CelestialKernels*> usableCelestialKernels() {
  return {&baseline::kCelestialKernels};
}

std::vector<const TileKernels*> usableTileKernels() {
  return {&baseline::kTileKernels};
}
#endif

const TileKernels& tileKernels() {
  static const TileKernels& fastest = *usableTileKernels().front();
  return fastest;
}

} // namespace viscera::coordinates::simd
