#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// Packs of doubles for kernels that are compiled once per instruction set. VISCERA_ISA names the set and
/// with it the namespace, so that the linker never mixes code for one processor into another. For the same
/// reason these files include nothing with inline functions of its own (Eigen, the standard library).
namespace viscera::coordinates::simd::VISCERA_ISA {

#if defined(__AVX512F__)
constexpr int kWidth = 8;
#elif defined(__AVX2__)
constexpr int kWidth = 4;
#else
constexpr int kWidth = 2;
#endif

typedef double Pack __attribute__((vector_size(kWidth * sizeof(double))));
/// The result of comparing packs: all ones or all zeros in each lane.
typedef long long Mask __attribute__((vector_size(kWidth * sizeof(long long))));

inline Pack load(const double* from) {
  Pack pack;
  __builtin_memcpy(&pack, from, sizeof pack);
  return pack;
}

inline void store(double* to, Pack pack) {
  __builtin_memcpy(to, &pack, sizeof pack);
}

/// The same number of lanes in single precision: half the memory, and roots and quotients in a third of the
/// time.
typedef float SinglePack __attribute__((vector_size(kWidth * sizeof(float))));

inline Pack load(const float* from) {
  SinglePack pack;
  __builtin_memcpy(&pack, from, sizeof pack);
  return __builtin_convertvector(pack, Pack);
}

inline void store(float* to, Pack pack) {
  const SinglePack rounded = __builtin_convertvector(pack, SinglePack);
  __builtin_memcpy(to, &rounded, sizeof rounded);
}

inline SinglePack loadSingle(const float* from) {
  SinglePack pack;
  __builtin_memcpy(&pack, from, sizeof pack);
  return pack;
}

inline Pack widened(SinglePack pack) {
  return __builtin_convertvector(pack, Pack);
}

inline Pack splat(double value) {
  return Pack{} + value;
}

inline Pack select(Mask mask, Pack yes, Pack no) {
  return mask ? yes : no;
}

inline Pack smaller(Pack a, Pack b) {
  return a < b ? a : b;
}
inline Pack larger(Pack a, Pack b) {
  return a > b ? a : b;
}

inline Pack magnitude(Pack value) {
  return larger(value, -value);
}

inline Pack squareRoot(Pack value) {
#if defined(__AVX512F__)
  // Not _mm512_sqrt_pd: GCC 12 warns about an uninitialised variable inside it.
  return (Pack)_mm512_maskz_sqrt_pd(0xff, (__m512d)value);
#elif defined(__AVX2__)
  return (Pack)_mm256_sqrt_pd((__m256d)value);
#elif defined(__SSE2__)
  return (Pack)_mm_sqrt_pd((__m128d)value);
#else
  for (int lane = 0; lane < kWidth; ++lane)
    value[lane] = __builtin_sqrt(value[lane]);
  return value;
#endif
}

inline SinglePack squareRoot(SinglePack value) {
#if defined(__AVX512F__)
  return (SinglePack)_mm256_sqrt_ps((__m256)value);
#elif defined(__AVX2__)
  return (SinglePack)_mm_sqrt_ps((__m128)value);
#else
  for (int lane = 0; lane < kWidth; ++lane)
    value[lane] = __builtin_sqrtf(value[lane]);
  return value;
#endif
}

/// Bit l is set where lane l is.
inline unsigned bits(Mask mask) {
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask((__m512i)mask);
#elif defined(__AVX2__) && !defined(__AVX512F__)
  return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask));
#else
  unsigned result = 0;
  for (int lane = 0; lane < kWidth; ++lane)
    result |= mask[lane] ? 1u << lane : 0u;
  return result;
#endif
}

/// The sum of the lanes, in a fixed order.
inline double sum(Pack pack) {
  double total = 0;
  for (int lane = 0; lane < kWidth; ++lane)
    total += pack[lane];
  return total;
}

} // namespace viscera::coordinates::simd::VISCERA_ISA
