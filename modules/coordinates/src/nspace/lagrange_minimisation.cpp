#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "choice_parameter.h"
#include "nspace/lagrange_problem.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

enum class Positivity { exact, free, localTest, globalTest, iterativeTest, iterative };
enum class Shift { raised, lowered };

const Parameter kTarget =
    choiceParameter("target", "Target weights", {"one", "inverse-distance", "closeness"});
const Parameter kPositivity =
    choiceParameter("positivity", "Treatment of negative weights",
                    {"exact", "free", "local-test", "global-test", "iterative-test", "iterative"});
const Parameter kShift =
    choiceParameter("shift", "Direction in which 'iterative' moves the target", {"raised", "lowered"});

/// Choices of handles without influence tried for one point.
constexpr int kMostLocalChoices = 20000;
/// Points times choices tried for all points together.
constexpr int kMostGlobalTrials = 4000000;
constexpr int kMostRounds = 200;
/// Part of the target's largest number: as good as not negative.
constexpr double kNotNegative = 1e-11;

/// The ways that look at one point only.
template <int Dim>
bool solveAlone(const LagrangeProblem<Dim>& problem, Positivity positivity, Values& beta) {
  switch (positivity) {
  case Positivity::exact:
    return problem.solveExactly(beta);
  case Positivity::localTest:
    return problem.solveByFewestZeros(kMostLocalChoices, beta);
  case Positivity::iterativeTest:
    return problem.solveByDropping(beta);
  default:
    return problem.solve({}, beta);
  }
}

using Problem = LagrangeProblem<3>;

bool madePositive(const Problem& problem, Values& beta) {
  if (beta.minCoeff() < -kNotNegative * problem.scale())
    return false;
  beta = beta.cwiseMax(0);
  return true;
}

/// One of the ways, with what one point cannot know by itself: the handles without influence, or the shift.
struct Way {
  Target target;
  Positivity positivity;
  std::optional<std::vector<Eigen::Index>> dead;
  double shift = 0;

  bool operator()(const HandleDirections& sight, Values& beta) const {
    const Problem problem(sight, targetAt(target, sight.distances));
    switch (positivity) {
    case Positivity::globalTest:
      return dead && problem.solve(*dead, beta) && madePositive(problem, beta);
    case Positivity::iterative:
      return problem.shifted(shift).solve({}, beta) && madePositive(problem, beta);
    default:
      return solveAlone(problem, positivity, beta);
    }
  }
};

std::vector<Problem> problemsAt(const Points& points, const Points& handles, Target target) {
  const DirectionSolver seen(handles, {});
  std::vector<Problem> problems;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (const auto sight = seen.sightFrom(points.row(i).transpose()))
      problems.emplace_back(*sight, targetAt(target, sight->distances));
  return problems;
}

/// The first choice of handles without influence that fits all problems; nothing where that takes too long. A
/// choice has `beta_i = 0` for its handles, and the others solve `sum (beta_i - t_i)^2 -> min` under
/// `sum beta_i u_i = 0`: one of the 2^n cases of the Kuhn-Tucker conditions (thesis 3.28).
std::optional<std::vector<Eigen::Index>> deadHandles(const std::vector<Problem>& problems, Eigen::Index count,
                                                     Progress& progress) {
  int trials = 0;
  std::size_t hardest = 0; // What stopped the last choice probably stops the next.
  Values beta(count);
  const auto fitsAll = [&](const std::vector<Eigen::Index>& dead) {
    progress.throwIfCancelled();
    for (std::size_t i = 0; i < problems.size(); ++i) {
      const std::size_t at = (hardest + i) % problems.size();
      if (++trials > kMostGlobalTrials)
        return false;
      if (!problems[at].solve(dead, beta) || beta.minCoeff() < -kNotNegative * problems[at].scale()) {
        hardest = at;
        return false;
      }
    }
    return true;
  };
  std::optional<std::vector<Eigen::Index>> found;
  for (Eigen::Index zeros = 0; zeros + 4 <= count && !found && trials <= kMostGlobalTrials; ++zeros)
    forEachSubset(count, zeros, [&](const std::vector<Eigen::Index>& dead) {
      if (fitsAll(dead))
        found = dead;
      return !found && trials <= kMostGlobalTrials;
    });
  return found;
}

/// The shift of the targets by which no number of any problem is negative.
double shiftFor(const std::vector<Problem>& problems, Eigen::Index count, double sign, Progress& progress) {
  double shift = 0;
  Values beta(count);
  for (int round = 0; round < kMostRounds; ++round) {
    progress.throwIfCancelled();
    double smallest = 0, scale = 0;
    for (const Problem& problem : problems)
      if (problem.shifted(shift).solve({}, beta)) {
        smallest = std::min(smallest, beta.minCoeff());
        scale = std::max(scale, problem.scale());
      }
    if (smallest >= -0.1 * kNotNegative * scale)
      break;
    // Let beta_min < 0 be the least of all: t_i + beta_min when lowered (thesis, below 3.29), t_i - beta_min
    // when raised.
    shift += sign * smallest;
  }
  return shift;
}

std::unique_ptr<const PointSolver> prepareLagrange(const HandleSet& handles, const Points& points,
                                                   const BindOptions& options, Progress& progress) {
  Way way{chosen<Target>(options.parameters, kTarget),
          chosen<Positivity>(options.parameters, kPositivity),
          {},
          0};
  const Points& positions = handles.positions;
  if (way.positivity == Positivity::globalTest)
    way.dead = deadHandles(problemsAt(points, positions, way.target), positions.rows(), progress);
  else if (way.positivity == Positivity::iterative)
    way.shift = shiftFor(problemsAt(points, positions, way.target), positions.rows(),
                         chosen<Shift>(options.parameters, kShift) == Shift::raised ? -1 : 1, progress);
  return std::make_unique<DirectionSolver>(positions, std::move(way));
}

} // namespace

BalanceIn<2> planeLagrange(const ParameterValues& parameters) {
  const auto target = chosen<Target>(parameters, kTarget);
  const auto positivity = chosen<Positivity>(parameters, kPositivity);
  if (positivity == Positivity::globalTest || positivity == Positivity::iterative)
    throw UsageError(misuse("\"%1\" needs all points at once, which planar coordinates do not support",
                            kPositivity.choices[static_cast<std::size_t>(positivity)]),
                     {}, "take another positivity");
  return [=](const HandleDirectionsOf<2>& sight, Values& beta) {
    return solveAlone(LagrangeProblem<2>(sight, targetAt(target, sight.distances)), positivity, beta);
  };
}

/// Coordinates by constrained least squares: of all balanced vectors the one nearest to a target (thesis
/// 3.3.1). Parameters:
/// * `target`: one, the inverse distance, or the closeness `1 - d / largest d`.
/// * `positivity`: the treatment of negative numbers.
///   - `exact` (ours): the quadratic programme (3.25) solved to the end, by Newton's method on its dual,
///   which
///     has three unknowns. Unique, positive, continuous.
///   - `free`: nothing (3.21).
///   - `local-test`: the feasible choice of handles without influence that has the fewest of them, point by
///     point. Of several the one nearest to the target. Gives up after 20,000 choices a point.
///   - `global-test`: the same choice for all points of the binding.
///   - `iterative-test`: negative ones are set to zero and the rest solved again.
///   - `iterative`: the target is shifted by the most negative number of all points until none is left; at
///     most 200 times, then points that still have one have no coordinates.
/// * `shift`: for `iterative`, the target is raised; or lowered, as the thesis prints it.
///
/// The solution of (3.25) is unique where the sign of the multipliers is tested as well; the thesis's local
/// test leaves it out, which is where its jumps come from. O(n) a point but for the tests, which try sets of
/// handles.
std::shared_ptr<const CoordinateSystem> lagrangeMinimisation() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "lagrange-minimisation",
          .name = "Lagrange minimisation",
          .summary =
              "Balanced weights nearest to a target; a parameter says how negative weights are treated",
          .traits = {.interpolates = true, .everywhere = false, .smooth = false},
          .parameters = {kTarget, kPositivity, kShift}},
      prepareLagrange);
}

} // namespace viscera::coordinates
