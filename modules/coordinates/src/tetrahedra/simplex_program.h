#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"

namespace viscera::coordinates {

/// The quadratic programme of bounded biharmonic weights, all handles at once.
struct SimplexProgram {
  Eigen::SparseMatrix<double> energy; ///< `n x n`, symmetric, positive semidefinite.
  Values mass;                        ///< `n`, positive: the weight of a point in residuals.
  std::vector<Eigen::Index> fixed;    ///< Ascending; point `fixed[j]` has weight 1 for handle j.
};

struct SimplexLimits {
  int mostIterations = 2000;
  double tolerance = 1e-4; ///< For both residuals.
};

/// Weights (`n x handles`) that are exactly non-negative with exact unity in every row, and how far from the
/// optimum they may be.
struct SimplexSolution {
  Eigen::MatrixXd weights;
  int iterations = 0;
  double primal = 0; ///< Root mean square of the remaining violation of the bounds, in units of a weight.
  double dual = 0;   ///< The same of the last change of a penalty step.
  bool converged = false;
};

/// Minimises `1/2 sum_h w_h^T E w_h` over rows in the standard simplex, by the alternating direction method
/// of multipliers (Boyd et al. 2011, doi 10.1561/2200000016, 3.3 and 3.4): one sparse factorisation, then a
/// solve for each handle and a projection of each row. The penalty follows the residuals. Bitwise independent
/// of the number of threads. Throws `Cancelled`, and `DataError` where the energy cannot be factorised.
SimplexSolution solveOnSimplex(const SimplexProgram& program, const SimplexLimits& limits, Threads threads,
                               Progress& progress);

/// The nearest point of the standard simplex, in place: no entry negative, sum 1. O(k log k).
void projectOnSimplex(Eigen::Ref<Eigen::RowVectorXd> row);

} // namespace viscera::coordinates
