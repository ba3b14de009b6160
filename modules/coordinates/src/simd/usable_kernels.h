#pragma once

#include <vector>

#include "viscera/coordinates/vector_bits.h"

/// Those versions of a family of kernels that can run here (`vectorBits`), the fastest first. A macro,
/// because the names of the faster ones exist only where they are compiled.
#if defined(__x86_64__)
#define VISCERA_USABLE_KERNELS(kernels)                                                                      \
  ::viscera::coordinates::simd::usableKernels(::viscera::coordinates::simd::avx512::kernels,                 \
                                              ::viscera::coordinates::simd::avx2::kernels,                   \
                                              ::viscera::coordinates::simd::baseline::kernels)
#else
#define VISCERA_USABLE_KERNELS(kernels)                                                                      \
  std::vector {                                                                                              \
    &::viscera::coordinates::simd::baseline::kernels                                                         \
  }
#endif

namespace viscera::coordinates::simd {

#if defined(__x86_64__)
template <class Kernels>
std::vector<const Kernels*> usableKernels(const Kernels& avx512, const Kernels& avx2,
                                          const Kernels& baseline) {
  std::vector<const Kernels*> usable;
  if (vectorBits() >= 512)
    usable.push_back(&avx512);
  if (vectorBits() >= 256)
    usable.push_back(&avx2);
  usable.push_back(&baseline);
  return usable;
}
#endif

} // namespace viscera::coordinates::simd
