#pragma once

#include <vector>

#include "viscera/coordinates/handle_checks.h"
#include "viscera/coordinates/tiled_weights.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"

namespace viscera::coordinates {

/// The convex function phi of one celestial system.
struct CelestialFunction;

const CelestialFunction& sFunction(); ///< S-Celestial coordinates': `phi'(t) = (t + sqrt(t^2 + 1))^2`.
const CelestialFunction& tFunction(); ///< T-Celestial coordinates': `phi(t) = exp(t)`.

/// The options of celestial coordinates that go beyond the thesis: locality and softness.
struct CelestialOptions {
  double locality = 0; ///< The exponent k >= 0.
  double softness = 0; ///< The length e >= 0, mm.
  Threads threads;
};

/// The coordinates of points and the solutions x of their convex problems.
template <int Dim>
struct CelestialSolution {
  TiledWeights weights;      ///< Rows of failed points are zero.
  PointsOf<Dim> x;           ///< `n x Dim`; zero for failed points and for those exactly at a handle.
  std::vector<int> failures; ///< Points outside the handles' hull (or not finite), ascending.
};

/// The celestial coordinates of `points` (`n x Dim`, Dim = 2 or 3) with respect to `handles`, for each point
/// p from the minimum of the convex `F(x) = sum m_i phi(q_i . x)` over the handles' directions `q_i = (v_i -
/// p) / D_i` (thesis 4.3, 4.4). Throws as `CoordinateSystem::bind` does. About 8 ns per (point x handle) of
/// one thread. Thread-safe, and bitwise independent of the number of threads.
template <int Dim>
CelestialSolution<Dim> solveCelestial(const CelestialFunction& function, const PointsOf<Dim>& handles,
                                      const PointsOf<Dim>& points, const CelestialOptions& options,
                                      Progress& progress);

} // namespace viscera::coordinates
