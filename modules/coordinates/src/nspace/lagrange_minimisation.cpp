#include "viscera/coordinates/nspace/lagrange_minimisation.h"

#include <optional>

#include "choice_parameter.h"
#include "nspace/lagrange_problem.h"
#include "nspace/plane_balances.h"
#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

enum class Positivity { exact, free, localTest, globalTest, iterativeTest, iterative };
enum class Shift { raised, lowered };

const Parameter kTarget =
    choiceParameter("target", "The numbers to stay near to", {"one", "inverse-distance", "closeness"});
const Parameter kPositivity =
    choiceParameter("positivity", "What is done about negative numbers",
                    {"exact", "free", "local-test", "global-test", "iterative-test", "iterative"});
const Parameter kShift =
    choiceParameter("shift", "Where 'iterative' moves the target", {"raised", "lowered"});

/// Choices of handles without influence tried for one point.
constexpr int kMostLocalChoices = 20000;
/// Points times choices tried for all points together.
constexpr int kMostGlobalTrials = 4000000;
constexpr int kMostRounds = 200;
/// Of the target's largest number: as good as not negative.
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

class Solver final : public DirectionSolver {
public:
  Solver(const Points& handles, Target target, Positivity positivity)
      : DirectionSolver(handles), target_(target), positivity_(positivity) {}

  /// Finds what one point cannot know by itself: the handles without influence, or the shift.
  void lookAt(const Points& points, Shift shift, Progress& progress) {
    if (positivity_ == Positivity::globalTest)
      findDeadHandles(points, progress);
    else if (positivity_ == Positivity::iterative)
      findShift(points, shift == Shift::raised ? -1 : 1, progress);
  }

private:
  std::optional<Problem> problemAt(const Vec3& point) const {
    if (handleAt(point) >= 0 || !inside(point))
      return std::nullopt;
    const Sight sight = sightOf<3>(handles(), point);
    return Problem(sight, targetAt(target_, sight.distances));
  }

  bool balance(const Sight& sight, Values& beta) const override {
    const Problem problem(sight, targetAt(target_, sight.distances));
    switch (positivity_) {
    case Positivity::globalTest:
      return dead_ && problem.solve(*dead_, beta) && madePositive(problem, beta);
    case Positivity::iterative:
      return problem.shifted(shift_).solve({}, beta) && madePositive(problem, beta);
    default:
      return solveAlone(problem, positivity_, beta);
    }
  }

  static bool madePositive(const Problem& problem, Values& beta) {
    if (beta.minCoeff() < -kNotNegative * problem.scale())
      return false;
    beta = beta.cwiseMax(0);
    return true;
  }

  void findDeadHandles(const Points& points, Progress& progress) {
    std::vector<Problem> problems;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      if (auto problem = problemAt(points.row(i).transpose()))
        problems.push_back(std::move(*problem));
    int trials = 0;
    std::size_t hardest = 0; // What stopped the last choice probably stops the next.
    Values beta(handles().rows());
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
    const auto count = handles().rows();
    for (Eigen::Index zeros = 0; zeros + 4 <= count && !dead_ && trials <= kMostGlobalTrials; ++zeros)
      forEachSubset(count, zeros, [&](const std::vector<Eigen::Index>& dead) {
        if (fitsAll(dead))
          dead_ = dead;
        return !dead_ && trials <= kMostGlobalTrials;
      });
  }

  void findShift(const Points& points, double sign, Progress& progress) {
    std::vector<Problem> problems;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      if (auto problem = problemAt(points.row(i).transpose()))
        problems.push_back(std::move(*problem));
    Values beta(handles().rows());
    for (int round = 0; round < kMostRounds; ++round) {
      progress.throwIfCancelled();
      double smallest = 0, scale = 0;
      for (const Problem& problem : problems)
        if (problem.shifted(shift_).solve({}, beta)) {
          smallest = std::min(smallest, beta.minCoeff());
          scale = std::max(scale, problem.scale());
        }
      if (smallest >= -0.1 * kNotNegative * scale)
        return;
      shift_ += sign * smallest;
    }
  }

  Target target_;
  Positivity positivity_;
  std::optional<std::vector<Eigen::Index>> dead_;
  double shift_ = 0;
};

} // namespace

PlaneBalance planeLagrange(const ParameterValues& parameters) {
  const auto target = chosen<Target>(parameters, kTarget);
  const auto positivity = chosen<Positivity>(parameters, kPositivity);
  if (positivity == Positivity::globalTest || positivity == Positivity::iterative)
    throw UsageError("'" + kPositivity.choices[static_cast<std::size_t>(positivity)] +
                         "' looks at all points together, which planar coordinates do not",
                     {}, "take another positivity");
  return [=](const SightIn<2>& sight, Values& beta) {
    return solveAlone(LagrangeProblem<2>(sight, targetAt(target, sight.distances)), positivity, beta);
  };
}

std::string LagrangeMinimisation::summary() const {
  return "As near to a target as balance allows; what is done about negative numbers can be chosen";
}

Traits LagrangeMinimisation::traits() const {
  Traits traits;
  traits.interpolates = true;
  traits.everywhere = false;
  traits.smooth = false;
  return traits;
}

std::vector<Parameter> LagrangeMinimisation::parameters() const {
  return {kTarget, kPositivity, kShift};
}

std::unique_ptr<const PointSolver> LagrangeMinimisation::prepare(const HandleSet& handles,
                                                                 const ParameterValues& parameters) const {
  return std::make_unique<Solver>(handles.positions, chosen<Target>(parameters, kTarget),
                                  chosen<Positivity>(parameters, kPositivity));
}

std::unique_ptr<const PointSolver> LagrangeMinimisation::prepareFor(const HandleSet& handles,
                                                                    const Points& points,
                                                                    const BindOptions& options,
                                                                    Progress& progress) const {
  auto solver = std::make_unique<Solver>(handles.positions, chosen<Target>(options.parameters, kTarget),
                                         chosen<Positivity>(options.parameters, kPositivity));
  solver->lookAt(points, chosen<Shift>(options.parameters, kShift), progress);
  return solver;
}

} // namespace viscera::coordinates
