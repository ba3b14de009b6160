#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "solved.h"

namespace viscera::circulation {

TEST(CirculationConservation, BloodVolumeStaysOverAThousandBeats) {
  const Parameters rest;
  Progress progress;
  const State start = guessedState(rest);
  const State end = afterBeats(rest, start, 1000, progress);
  EXPECT_NEAR(totalVolume(start), rest.stressedVolume, 1e-9);
  EXPECT_NEAR(totalVolume(end), rest.stressedVolume, 1e-9);
}

TEST(CirculationConservation, TheSearchKeepsTheBloodVolumeInEveryScenario) {
  for (const Scenario& scenario : scenarios()) {
    const Solved solved = solve(scenario.id);
    EXPECT_NEAR(totalVolume(solved.state.start), solved.parameters.stressedVolume, 1e-9) << scenario.id;
  }
}

TEST(CirculationConservation, AnAtriumThatIsLargerWithoutPressureMovesNoPressureInAnyScenario) {
  constexpr double kLeft = -15, kRight = -25;
  for (const Scenario& scenario : scenarios()) {
    const Solved ours = solve(scenario.id);
    Parameters smaller = ours.parameters;
    smaller.la.v0 += kLeft;
    smaller.ra.v0 += kRight;
    smaller.stressedVolume += kLeft + kRight;
    smaller.pericardialRoom += kLeft + kRight;
    const Solved other = solve(smaller);
    for (std::size_t i = 0; i < ours.state.beat.time.size(); ++i) {
      for (const Compartment c : {Compartment::lv, Compartment::rv, Compartment::la, Compartment::ra,
                                  Compartment::systemicArteries, Compartment::pulmonaryArteries})
        ASSERT_NEAR(other.state.beat.pressureOf(c)[i], ours.state.beat.pressureOf(c)[i], 1e-4) << scenario.id;
      ASSERT_NEAR(other.state.beat.volumeOf(Compartment::lv)[i], ours.state.beat.volumeOf(Compartment::lv)[i],
                  1e-4);
      ASSERT_NEAR(other.state.beat.volumeOf(Compartment::la)[i] - kLeft,
                  ours.state.beat.volumeOf(Compartment::la)[i], 1e-4);
      ASSERT_NEAR(other.state.beat.volumeOf(Compartment::ra)[i] - kRight,
                  ours.state.beat.volumeOf(Compartment::ra)[i], 1e-4);
    }
  }
}

TEST(CirculationConservation, AreaOfEachLoopIsTheWorkThatWasIntegrated) {
  for (const Scenario& scenario : scenarios()) {
    const Solved solved = solve(scenario.id);
    for (const Compartment ventricle : {Compartment::lv, Compartment::rv}) {
      const ChamberIndices& of = solved.indices.of(ventricle);
      EXPECT_GT(of.strokeWorkJ, 0.05) << scenario.id;
      EXPECT_NEAR(of.strokeWorkJ / of.strokeWorkByEnergyJ, 1, 1e-6) << scenario.id;
    }
  }
}

TEST(CirculationConservation, TheHeartsWorkIsTheHeatOfValvesAndVessels) {
  for (const Scenario& scenario : scenarios()) {
    const Beat beat = solve(scenario.id).state.beat;
    const double work = std::accumulate(beat.work.begin(), beat.work.end(), 0.0);
    EXPECT_NEAR(work / beat.dissipated, 1, 1e-6) << scenario.id;
  }
}

/// All numbers that are shown, for comparison; dP/dt is one of ventricles.
std::vector<double> numbersOf(const Indices& indices) {
  std::vector<double> numbers;
  for (const Compartment ventricle : {Compartment::lv, Compartment::rv})
    numbers.push_back(indices.of(ventricle).dpdtMax);
  for (const ChamberIndices& c : indices.chambers)
    numbers.insert(numbers.end(), {c.edvMl, c.esvMl, c.svMl, c.ef, c.edpMmHg, c.meanMmHg, c.highestMmHg});
  for (const ArteryIndices& a : {indices.aorta, indices.pulmonaryArtery})
    numbers.insert(numbers.end(), {a.systolic, a.diastolic, a.mean});
  for (const Compartment ventricle : {Compartment::lv, Compartment::rv})
    numbers.push_back(indices.of(ventricle).strokeWorkJ);
  numbers.insert(numbers.end(),
                 {indices.forwardStrokeMl, indices.cardiacOutputLMin, indices.arterialElastance,
                  indices.couplingRatio, indices.relaxationSeconds});
  return numbers;
}

TEST(CirculationConservation, HalfTheStepChangesNoNumber) {
  for (const Scenario& scenario : scenarios()) {
    const Parameters parameters = scenarioParameters(scenario.id);
    const auto whole = numbersOf(solve(parameters).indices);
    const auto half = numbersOf(solve(parameters, {.samples = 2000, .step = 0.0005}).indices);
    for (std::size_t i = 0; i < whole.size(); ++i)
      EXPECT_NEAR(whole[i], half[i], 1e-4 * std::max(1.0, std::abs(half[i])))
          << scenario.id << ", number " << i;
  }
}

} // namespace viscera::circulation
