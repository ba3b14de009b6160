#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/progress.h"

/// Implements the thesis's method to solve the T-Celestial equations (4.3.2), for comparison: Newton's method
/// without damping, begun at each point with the solution of a neighbour. The program's own coordinates do
/// not need it: their damped method finds every solution from zero.
namespace viscera::coordinates {

/// The order in which the neighbours of a solved point are tried.
enum class NeighbourOrder {
  euclidean, ///< By their distance to the point.
  jacobian   ///< By `|J p|`, J the derivative at the point with the neighbour's solution, p from the handles'
             ///< middle.
};

struct NewtonSpreadOptions {
  double radius = 0;       ///< Points nearer than this are neighbours, mm.
  int mostIterations = 10; ///< Attempts that need more count as not converged.
  double tolerance = 1e-6; ///< Of |sum exp(psi . q_i) q_i|, the thesis's.
};

struct NewtonSpread {
  /// `solvedBy[k]`: points solved from the neighbour tried as number k + 1.
  std::vector<Eigen::Index> solvedBy;
  Eigen::Index seeds = 0;    ///< Points solved from the linearised equations: one for each connected part.
  Eigen::Index unsolved = 0; ///< Points for which no neighbour's solution led to convergence.
  double meanIterations = 0; ///< Of the attempts that converged, but for seeds.

  /// The share of the points solved from a neighbour for which the first one did.
  double shareByFirst() const;
};

/// Solves all `points` (`n x 3`, mm, inside the handles' hull) by spreading from the first one that can be
/// solved. Deterministic. O(n^2) for the neighbours. Throws `Cancelled`.
NewtonSpread spreadNewton(const Points& handles, const Points& points, NeighbourOrder order,
                          const NewtonSpreadOptions& options, Progress& progress);

} // namespace viscera::coordinates
