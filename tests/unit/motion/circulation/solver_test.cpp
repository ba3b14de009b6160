#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "solved.h"
#include "viscera/core/error.h"

namespace viscera::circulation {
namespace {

double largestDifference(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t i = 0; i < kCompartments; ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

} // namespace

TEST(CirculationSolver, FindsWhatBeatAfterBeatComesTo) {
  const Solved fast = solve("rest");
  const Solved slow = solve(Parameters(), {.accelerate = false});
  ASSERT_TRUE(fast.state.converged);
  ASSERT_TRUE(slow.state.converged);
  EXPECT_LT(largestDifference(fast.state.start, slow.state.start), 1e-5);
  EXPECT_LT(2 * fast.state.beats, slow.state.beats);
}

TEST(CirculationSolver, EveryScenarioConvergesAndRepeatsItself) {
  for (const Scenario& scenario : scenarios()) {
    const Solved solved = solve(scenario.id);
    EXPECT_TRUE(solved.state.converged) << scenario.id << ": " << solved.state.failureReason;
    EXPECT_TRUE(solved.state.failureReason.empty());
    const Beat& beat = solved.state.beat;
    for (std::size_t i = 0; i < kCompartments; ++i) {
      EXPECT_NEAR(beat.volume[i].front(), beat.volume[i].back(), 1e-6) << scenario.id;
      EXPECT_NEAR(beat.pressure[i].front(), beat.pressure[i].back(), 1e-4) << scenario.id;
    }
  }
}

TEST(CirculationSolver, BeginsFromANearbyStateAndEndsAtTheSame) {
  const Solved rest = solve("rest");
  Parameters changed;
  changed.systemic.resistance *= 1.05;
  changed.stressedVolume += 20;
  Progress progress;
  const PeriodicState near = findPeriodicState(changed, progress, {}, &rest.state.start);
  const PeriodicState afresh = findPeriodicState(changed, progress);
  ASSERT_TRUE(near.converged);
  EXPECT_NEAR(totalVolume(near.start), changed.stressedVolume, 1e-9);
  EXPECT_LT(largestDifference(near.start, afresh.start), 1e-5);
  EXPECT_LE(near.beats, afresh.beats + 1);
}

TEST(CirculationSolver, ConvergesAtTheEndsOfEveryControl) {
  for (const ParameterInfo& info : parameterInfos()) {
    if (!info.control || info.name == "pericardialFluid" || info.name == "mitralLeak" ||
        info.name == "aorticLeak")
      continue;
    for (const double value : {info.lowest, info.highest}) {
      Parameters parameters;
      setParameter(parameters, info.name, value);
      EXPECT_TRUE(solve(parameters).state.converged) << info.name << " = " << value;
    }
  }
}

TEST(CirculationSolver, SaysWhenNoBeatRepeatsItself) {
  const Solved solved = solve(Parameters(), {.mostBeats = 4});
  EXPECT_FALSE(solved.state.converged);
  EXPECT_GT(solved.state.residual, 1e-7);
  EXPECT_NE(solved.state.failureReason.english().find("After"), std::string::npos)
      << solved.state.failureReason;
  EXPECT_NE(solved.state.failureReason.english().find("try"), std::string::npos);
}

TEST(CirculationSolver, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(findPeriodicState(Parameters(), progress), Cancelled);
}

TEST(CirculationSolver, RefusesParametersOutOfRange) {
  Parameters parameters;
  parameters.systemic.resistance = -1;
  Progress progress;
  EXPECT_THROW(findPeriodicState(parameters, progress), UsageError);
}

} // namespace viscera::circulation
