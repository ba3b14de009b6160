#pragma once

#include "simd/pack.h"

/// Exponential and logarithm of packs.
namespace viscera::coordinates::simd::VISCERA_ISA {

/// Beyond this the exponential leaves the range of a double.
constexpr double kLargestExponent = 708;

/// e^value with a relative error below 4e-16, for values that are clamped to +-708. The argument is reduced
/// to `value = n ln 2 + r`, |r| <= ln 2 / 2, ln 2 in two parts (Cody and Waite), and e^r is its Taylor
/// polynomial of degree 13, whose remainder is below 5e-18.
inline Pack exponential(Pack value) {
  constexpr double kLog2E = 1.4426950408889634074, kLn2High = 6.93147180369123816490e-01,
                   kLn2Low = 1.90821492927058770002e-10;
  constexpr double kRound =
      6755399441055744.0; // 1.5 * 2^52: adding it leaves the nearest integer in the low bits.
  value = smaller(larger(value, splat(-kLargestExponent)), splat(kLargestExponent));
  const Pack shifted = value * kLog2E + kRound;
  const Pack whole = shifted - kRound;
  const Pack rest = (value - whole * kLn2High) - whole * kLn2Low;
  Pack power = splat(1.0 / 6227020800.0);
  constexpr double kInverseFactorials[] = {
      1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
      1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1.0,         1.0};
  for (const double coefficient : kInverseFactorials)
    power = power * rest + coefficient;
  const Mask exponent = ((Mask)shifted - (Mask)splat(kRound)) << 52;
  return (Pack)((Mask)power + exponent);
}

/// ln(value) for positive, normal values: `value = 2^n m`, m in [sqrt(1/2), sqrt(2)), and
/// ln m = 2 artanh(s), s = (m - 1) / (m + 1), as a series in s^2 <= 0.0295; relative error below 1e-15.
inline Pack logarithm(Pack value) {
  constexpr double kLn2 = 0.69314718055994530942;
  constexpr long long kMantissa = 0x000fffffffffffffLL, kOne = 0x3ff0000000000000LL;
  constexpr long long kMagic =
      0x4330000000000000LL; // 2^52 as bits: integers below 2^51 become doubles by or-ing.
  const Mask pattern = (Mask)value;
  Pack mantissa = (Pack)((pattern & kMantissa) | kOne);
  const Mask biased = (pattern >> 52) & 0x7ff;
  Pack exponent = (Pack)(biased | kMagic) - (4503599627370496.0 + 1023.0);
  const Mask large = mantissa > splat(1.41421356237309504880);
  mantissa = select(large, mantissa * 0.5, mantissa);
  exponent = select(large, exponent + 1.0, exponent);
  const Pack s = (mantissa - 1.0) / (mantissa + 1.0);
  const Pack s2 = s * s;
  Pack series = splat(1.0 / 19);
  for (int odd = 17; odd >= 1; odd -= 2)
    series = series * s2 + 1.0 / odd;
  return exponent * kLn2 + 2.0 * s * series;
}

} // namespace viscera::coordinates::simd::VISCERA_ISA
