#include "viscera/elasticity/static_solution.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "sparse_system.h"
#include "viscera/elasticity/tissues.h"

namespace viscera::elasticity {
namespace {

/// A load step that takes no more Newton steps than these is followed by a larger one.
constexpr int kQuick = 6;
constexpr double kGrowth = 1.5;
/// Forces that grow by this factor in a Newton step are on no way to balance.
constexpr double kDiverging = 1e6;
/// Smaller forces than this part of the shear modulus on a face of the body's size are rounding, as those of
/// a body that moves as a whole.
constexpr double kLeastForce = 1e-4;

void requireThere(const ElasticBody& body, const Loads& loads) {
  for (const Prescribed& one : loads.prescribed)
    if (one.node < 0 || one.node >= body.mesh().nodes.rows() || one.axis < 0 || one.axis > 2 ||
        !std::isfinite(one.displacementMm))
      throw DataError(misuse("the displacement of node %1 cannot be prescribed", one.node));
  for (const Pressure& pressure : loads.pressures)
    for (const Face& face : pressure.faces)
      if (face.tetrahedron < 0 || face.tetrahedron >= body.mesh().tetrahedra.rows() || face.opposite < 0 ||
          face.opposite > 3)
        throw DataError(misuse("face %1 of tetrahedron %2 does not exist", face.opposite, face.tetrahedron));
}

/// Newton's method in load steps.
class LoadedBody {
public:
  LoadedBody(const ElasticBody& body, const Loads& loads, const SolveOptions& options, Progress& progress)
      : body_(body), options_(options), progress_(progress), targets_(Values::Zero(body.unknowns())),
        isFree_(freeOf(body, loads)), system_(body, isFree_, loads) {
    for (const Prescribed& one : loads.prescribed)
      targets_[3 * Eigen::Index(one.node) + one.axis] = one.displacementMm;
    solution_.state = Values::Zero(body.unknowns());
  }

  StaticSolution solve() {
    double reached = 0, step = 1.0 / std::max(1, options_.loadSteps);
    while (reached < 1) {
      progress_.report(reached, "Find the equilibrium");
      const double next = reached + step > 1 - 1e-9 ? 1 : reached + step;
      if (const int taken = balance(reached, next); taken > 0) {
        reached = next;
        ++solution_.loadSteps;
        if (taken <= kQuick)
          step *= kGrowth;
      } else if ((step *= 0.5) < options_.smallestStep) {
        throw NoEquilibrium(reached);
      }
    }
    finish();
    return std::move(solution_);
  }

private:
  static std::vector<bool> freeOf(const ElasticBody& body, const Loads& loads) {
    std::vector<bool> isFree(static_cast<std::size_t>(body.unknowns()), true);
    for (const Prescribed& one : loads.prescribed)
      isFree[static_cast<std::size_t>(3 * one.node + one.axis)] = false;
    return isFree;
  }

  /// The imbalance of `sums` relative to the forces of the tissue, displacements and pressures each.
  double imbalanceOf(const SparseSystem::Sums& sums) const {
    const Eigen::Index displacements = 3 * body_.mesh().nodes.rows();
    double off = 0;
    for (Eigen::Index i = 0; i < displacements; ++i)
      if (isFree_[static_cast<std::size_t>(i)])
        off += sums.force[i] * sums.force[i];
    const double least = kLeastForce * body_.material().shear() * std::pow(body_.volumeMm3(), 2.0 / 3);
    const double forces = std::max(sums.inner.head(displacements).norm(), least);
    const double volume = body_.volumeMm3() / std::sqrt(double(body_.mesh().corners));
    return std::max(std::sqrt(off) / forces, sums.force.tail(body_.mesh().corners).norm() / volume);
  }

  /// Newton's method at the part `to` of the load, from the equilibrium at `from`. The number of its steps,
  /// or 0 when it fails; the state is then as it was.
  int balance(double from, double to) {
    Values state = solution_.state;
    Values ahead = (to - from) * targets_;
    double first = 0;
    for (int iteration = 1; iteration <= options_.mostIterations; ++iteration) {
      const SparseSystem::Sums sums = system_.assemble(state, to, ahead, options_.threads, progress_);
      if (!(sums.smallestJacobian > 0) || !sums.force.allFinite())
        return 0;
      const bool arrived = ahead.isZero(0);
      const double imbalance = imbalanceOf(sums);
      if (arrived && (imbalance <= options_.tolerance || sums.force.isZero(0))) {
        solution_.state = state;
        solution_.imbalance = imbalance;
        return iteration;
      }
      const double off = sums.force.norm();
      if (iteration == 2)
        first = off;
      if (iteration > 2 && off > kDiverging * first)
        return 0;
      const Values step = system_.step(ahead);
      if (step.size() == 0)
        return 0;
      ++solution_.iterations;
      state += step;
      ahead.setZero();
    }
    return 0;
  }

  void finish() {
    const Eigen::Index nodes = body_.mesh().nodes.rows();
    solution_.displacements = Eigen::Map<const Points>(solution_.state.data(), nodes, 3);
    solution_.smallestJacobian = 1e300;
    solution_.largestJacobian = 0;
    for (Eigen::Index t = 0; t < body_.mesh().tetrahedra.rows(); ++t)
      for (const LocalState& at : body_.statesOf(t, solution_.state)) {
        const double j = at.gradient.determinant();
        solution_.smallestJacobian = std::min(solution_.smallestJacobian, j);
        solution_.largestJacobian = std::max(solution_.largestJacobian, j);
        const double direct = body_.directBulk(), p = at.pressureKpa - direct * (j - 1);
        solution_.energyMj +=
            at.weightMm3 / kMm3PerMl *
            (body_.material().respond(at.gradient).energy + 0.5 * direct * (j - 1) * (j - 1) +
             0.5 * p * p / (body_.material().bulk() - direct));
      }
  }

  const ElasticBody& body_;
  const SolveOptions& options_;
  Progress& progress_;
  Values targets_;
  std::vector<bool> isFree_;
  SparseSystem system_;
  StaticSolution solution_;
};

} // namespace

NoEquilibrium::NoEquilibrium(double reached)
    : DataError(diagnostic("no equilibrium is found beyond %1 % of the load", inFixed(100 * reached, 0)), {},
                "move the handles less far, or hold more of the body"),
      reached_(reached) {}

StaticSolution solveStatic(const ElasticBody& body, const Loads& loads, const SolveOptions& options,
                           Progress& progress) {
  requireThere(body, loads);
  return LoadedBody(body, loads, options, progress).solve();
}

TissueStress tissueStress(const ElasticBody& body, const Values& state) {
  std::vector<std::pair<double, double>> samples; // Stress and volume.
  TissueStress stress;
  for (Eigen::Index t = 0; t < body.mesh().tetrahedra.rows(); ++t)
    for (const LocalState& at : body.statesOf(t, state)) {
      samples.emplace_back(vonMisesKpa(body.material(), at.gradient), at.weightMm3);
      stress.mean += samples.back().first * at.weightMm3 / body.volumeMm3();
    }
  std::sort(samples.begin(), samples.end());
  stress.max = samples.back().first;
  double volume = 0;
  for (const auto& [value, part] : samples)
    if ((volume += part) <= 0.95 * body.volumeMm3())
      stress.p95 = value;
  return stress;
}

} // namespace viscera::elasticity
