#pragma once

/// The convex problem behind the point-based celestial coordinates, solved for a tile of points at a time;
/// compiled for several instruction sets.
///
/// With the handles seen from a point p as `q_i = (v_i - p) / D_i`, `D_i = sqrt(|v_i - p|^2 + e^2)` (e the
/// softness) and the prior weights `m_i = (D_i / min D)^-k` (k the locality), each point asks for the x that
/// minimises `F(x) = sum m_i phi(q_i . x)`. Its gradient is then zero: `sum beta_i q_i = 0` with `beta_i =
/// m_i phi'(q_i . x)`, and the coordinates are `w_i = beta_i / D_i`, normalised.
namespace viscera::coordinates::simd {

struct CelestialProblem {
  const double* handles; ///< `dimension x count`: all x, then all y, ...
  long count;
  double locality;
  double softnessSquared;
  double
      samePlaceSquared; ///< Without softness, a point this near to a handle gets that handle's coordinate 1.
  double tolerance;     ///< Of `|sum beta_i q_i|` relative to `sum beta_i`.
};

/// Doubles of scratch memory that a kernel needs for each handle.
inline constexpr int kCelestialScratch = 8 * 8;

/// Solves for 16 points (`points` is `dimension x 16`), writes their coordinates to the tile (`count x 16`)
/// and the solutions x to `solutions` (`dimension x 16`). Gives a bit for each point without a solution,
/// whose numbers are zero. A point's results do not depend on the others in its tile.
using SolveCelestialTile = unsigned (*)(const CelestialProblem& problem, const double* points,
                                        double* scratch, double* tile, double* solutions);

struct CelestialKernels {
  SolveCelestialTile s2, s3; ///< S-Celestial in two and three dimensions.
  SolveCelestialTile t2, t3; ///< T-Celestial.
};

namespace baseline {
extern const CelestialKernels kCelestialKernels;
}
namespace avx2 {
extern const CelestialKernels kCelestialKernels;
}
namespace avx512 {
extern const CelestialKernels kCelestialKernels;
}

} // namespace viscera::coordinates::simd
