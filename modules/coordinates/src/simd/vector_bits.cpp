#include "viscera/coordinates/vector_bits.h"

#include <algorithm>
#include <cstdlib>

namespace viscera::coordinates {
namespace {

int bitsOfProcessor() {
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  return avx512 ? 512 : avx2 ? 256 : 128;
#else
  return 128;
#endif
}

int bitsAllowed() {
  const char* text = std::getenv("VISCERA_VECTOR_BITS");
  const int asked = text ? std::atoi(text) : 0;
  return asked > 0 ? asked : 512;
}

} // namespace

int vectorBits() {
  static const int bits = [] {
    const int most = std::min(bitsOfProcessor(), bitsAllowed());
    return most >= 512 ? 512 : most >= 256 ? 256 : 128;
  }();
  return bits;
}

} // namespace viscera::coordinates
