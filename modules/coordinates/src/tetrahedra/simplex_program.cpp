#include "tetrahedra/simplex_program.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/SparseCholesky>

#include "tetrahedra/finite_elements.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

/// Iterations between two looks at the penalty.
constexpr int kRhythm = 20;
/// Residuals that differ by less leave the penalty as it is.
constexpr double kImbalance = 5;
constexpr double kMostChange = 20;
/// The usual over-relaxation.
constexpr double kRelaxation = 1.6;
constexpr Eigen::Index kRows = 256;

/// The iteration over the free points; the fixed ones are in `pull_`.
class Splitting {
public:
  Splitting(const SimplexProgram& program, Threads threads)
      : split_(program.energy, program.fixed), threads_(threads),
        pull_(-Eigen::MatrixXd(split_.freeWithFixed)), mass_(split_.free.size()) {
    for (std::size_t i = 0; i < split_.free.size(); ++i)
      mass_[static_cast<Eigen::Index>(i)] = program.mass[split_.free[i]];
    const double total = mass_.sum();
    if (total > 0)
      mass_ /= total; // Residuals are then mean squares.
    const Values stiff = split_.amongFree.diagonal().cwiseQuotient(mass_);
    penalty_ = std::sqrt(stiff.minCoeff());
    system_ = split_.amongFree;
    solver_.analyzePattern(system_);
    factorise();
    z_ = Eigen::MatrixXd::Zero(pull_.rows(), pull_.cols());
    u_ = z_;
  }

  /// One round of the method.
  void step(Progress& progress) {
    // Boyd 3.1.1, with M the mass in the penalty's norm: x = argmin x^T E x / 2 + rho/2 |x - z + u|_M^2 for
    // each handle, (E_ff + rho M) x = -E_fb w_b + rho M (z - u). The fixed weights w_b are the identity.
    Eigen::MatrixXd x(z_.rows(), z_.cols());
    parallelRanges(z_.cols(), 1, threads_, [&](Eigen::Index column, Eigen::Index) {
      progress.throwIfCancelled();
      const Values wanted =
          pull_.col(column).array() + penalty_ * mass_.array() * (z_.col(column) - u_.col(column)).array();
      x.col(column) = solver_.solve(wanted);
    });
    const Eigen::MatrixXd before = z_;
    parallelRanges(z_.rows(), kRows, threads_, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index row = begin; row < end; ++row) {
        // Boyd 3.4.3 with x - z = 0 for the constraint: x' = alpha x + (1 - alpha) z, then z = P(x' + u) and
        // u = u + x' - z. M weighs the entries of a row alike, so P is the plain projection.
        const Eigen::RowVectorXd relaxed = kRelaxation * x.row(row) + (1 - kRelaxation) * z_.row(row);
        Eigen::RowVectorXd projected = relaxed + u_.row(row);
        projectOnSimplex(projected);
        u_.row(row) += relaxed - projected;
        z_.row(row) = projected;
      }
    });
    // r = x - z is what is left of the constraint, and s = rho M (z - z_before) of the gradient; here s
    // without rho M, so that both are in units of a weight.
    primal_ = meanSquare(x - z_);
    dual_ = meanSquare(z_ - before);
  }

  double primal() const { return primal_; }
  double dual() const { return dual_; }
  const Eigen::MatrixXd& weights() const { return z_; }
  const std::vector<Eigen::Index>& free() const { return split_.free; }

  /// Raises the penalty where the bounds are met too slowly, lowers it where the energy falls too slowly.
  void balance() {
    if (primal_ <= kImbalance * dual_ && dual_ <= kImbalance * primal_)
      return;
    // Boyd 3.4.1, but in proportion: rho grows by sqrt(|r| / |s|). u is the multipliers over rho, so it
    // shrinks by as much.
    const double ratio = dual_ > 0 ? std::sqrt(primal_ / dual_) : kMostChange;
    const double change = std::clamp(ratio, 1 / kMostChange, kMostChange);
    penalty_ *= change;
    u_ /= change;
    factorise();
  }

private:
  void factorise() {
    system_ = split_.amongFree;
    for (Eigen::Index i = 0; i < mass_.size(); ++i)
      system_.coeffRef(i, i) += penalty_ * mass_[i];
    solver_.factorize(system_);
    if (solver_.info() != Eigen::Success)
      throw DataError(misuse("the biharmonic energy cannot be factorised"), "the handles' tetrahedra",
                      "try another resolution");
  }

  double meanSquare(const Eigen::MatrixXd& rows) const {
    return std::sqrt(mass_.dot(rows.rowwise().squaredNorm()));
  }

  SplitSystem split_;
  Threads threads_;
  Eigen::MatrixXd pull_;
  Values mass_;
  double penalty_ = 1;
  Eigen::SparseMatrix<double> system_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  Eigen::MatrixXd z_, u_; ///< The projected weights and the scaled multipliers.
  double primal_ = 0, dual_ = 0;
};

} // namespace

void projectOnSimplex(Eigen::Ref<Eigen::RowVectorXd> row) {
  // min |w - row|^2 with w_i >= 0 and sum w_i = 1 has w_i = max(0, row_i - theta). Descending, theta = (row_1
  // + ... + row_k - 1) / k with the last k for which row_k > theta. What rounding leaves of the sum goes out
  // by division.
  Eigen::RowVectorXd sorted = row;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  double sum = 0, shift = 0;
  for (Eigen::Index i = 0; i < sorted.size(); ++i) {
    sum += sorted[i];
    const double trial = (sum - 1) / static_cast<double>(i + 1);
    if (sorted[i] - trial > 0)
      shift = trial;
  }
  row = (row.array() - shift).max(0);
  row /= row.sum();
}

SimplexSolution solveOnSimplex(const SimplexProgram& program, const SimplexLimits& limits, Threads threads,
                               Progress& progress) {
  SimplexSolution solution;
  const auto handles = static_cast<Eigen::Index>(program.fixed.size());
  solution.weights = Eigen::MatrixXd::Zero(program.energy.rows(), handles);
  for (Eigen::Index handle = 0; handle < handles; ++handle)
    solution.weights(program.fixed[static_cast<std::size_t>(handle)], handle) = 1;
  if (handles == program.energy.rows()) {
    solution.converged = true;
    return solution;
  }
  Splitting splitting(program, threads);
  while (!solution.converged && solution.iterations < limits.mostIterations) {
    progress.throwIfCancelled();
    splitting.step(progress);
    ++solution.iterations;
    solution.primal = splitting.primal();
    solution.dual = splitting.dual();
    solution.converged = solution.primal <= limits.tolerance && solution.dual <= limits.tolerance;
    if (!solution.converged && solution.iterations % kRhythm == 0)
      splitting.balance();
    progress.report(static_cast<double>(solution.iterations) / limits.mostIterations,
                    "bounded biharmonic weights");
  }
  for (std::size_t i = 0; i < splitting.free().size(); ++i)
    solution.weights.row(splitting.free()[i]) = splitting.weights().row(static_cast<Eigen::Index>(i));
  return solution;
}

} // namespace viscera::coordinates
