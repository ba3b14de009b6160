#pragma once

#include "simd/pack_math.h"

/// The convex functions phi of the celestial coordinates with their first and second derivatives.
namespace viscera::coordinates::simd::VISCERA_ISA {

struct FunctionValues {
  Pack value;
  Pack first;
  Pack second;
};

/// phi' and phi'' in single precision.
struct SingleSlopes {
  SinglePack first;
  SinglePack second;
};

/// S-Celestial: with r = sqrt(t^2 + 1) and u = t + r, phi = u^3/6 + u/2, phi' = u^2, phi'' = 2 u^2 / r. (phi
/// is 2t^3/3 + t + 2r^3/3 in a form that does not cancel for negative t; u is 1/(r - t) there for the same
/// reason.)
struct SFunction {
  /// Equals to the bit what `evaluate` gives there.
  static constexpr FunctionValues kAtZero = {Pack{} + (1.0 / 6.0 + 0.5), Pack{} + 1.0, Pack{} + 2.0};
  static constexpr bool kHasSingle = true;

  static FunctionValues evaluate(Pack t) {
    const Pack r = squareRoot(t * t + 1.0);
    const Pack large = larger(t, -t) + r;
    const Pack inverse = 1.0 / (large * r); // One division serves both 1/large and 1/r.
    const Pack u = select(t < 0.0, inverse * r, large);
    const Pack square = u * u;
    return {u * (square * (1.0 / 6.0) + 0.5), square, 2.0 * square * (inverse * large)};
  }

  static SingleSlopes slopes(SinglePack t) {
    const SinglePack r = squareRoot(t * t + 1.0f);
    const SinglePack large = (t < 0.0f ? -t : t) + r;
    const SinglePack inverse = 1.0f / (large * r);
    const SinglePack u = t < 0.0f ? inverse * r : large;
    const SinglePack square = u * u;
    return {square, 2.0f * square * (inverse * large)};
  }

  static Pack first(Pack t) {
    const Pack large = larger(t, -t) + squareRoot(t * t + 1.0);
    const Pack u = select(t < 0.0, 1.0 / large, large);
    return u * u;
  }
};

/// T-Celestial: phi, phi' and phi'' are all e^t.
struct TFunction {
  static constexpr bool kHasSingle = false;
  static constexpr FunctionValues kAtZero = {Pack{} + 1.0, Pack{} + 1.0, Pack{} + 1.0};

  static FunctionValues evaluate(Pack t) {
    const Pack power = exponential(t);
    return {power, power, power};
  }

  static Pack first(Pack t) { return exponential(t); }
};

} // namespace viscera::coordinates::simd::VISCERA_ISA
