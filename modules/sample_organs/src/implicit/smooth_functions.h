#pragma once

#include <algorithm>
#include <cmath>

#include "viscera/core/arrays.h"

namespace viscera::sample_organs {

/// Minimum of two distances with a fillet: where they differ by less than `blend` mm, up to `blend / 4` is
/// taken off (the quadratic polynomial minimum, continuous to its first derivative). `blend` 0 gives the
/// plain minimum.
inline double smoothMin(double a, double b, double blend) {
  const double lower = std::min(a, b);
  if (blend <= 0)
    return lower;
  const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
  return lower - 0.25 * blend * overlap * overlap;
}

/// The same for a maximum.
inline double smoothMax(double a, double b, double blend) {
  return -smoothMin(-a, -b, blend);
}

/// 0 below `from`, 1 above `to`, a cubic with level ends between.
inline double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Smooth noise in [-1, 1]: a random value for every point of the integer lattice, blended by quintics (two
/// continuous derivatives). The same `seed` gives the same noise everywhere.
double valueNoise(const Vec3& point, int seed);

} // namespace viscera::sample_organs
