#include "viscera/circulation/valve_state.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "solved.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/signs.h"

namespace viscera::circulation {
namespace {

bool within(const ValveTimes& times, double seconds) {
  return times.opens < times.shuts ? seconds > times.opens && seconds < times.shuts
                                   : seconds > times.opens || seconds < times.shuts;
}

TEST(ValveState, ShutLeafletsTouchAndOpenOnesDoNot) {
  EXPECT_FALSE(isOpen(0));
  EXPECT_FALSE(isOpen(kTouching));
  EXPECT_EQ(apart(kTouching), 0);
  EXPECT_GT(apart(kTouching + 1e-6), 0);
  EXPECT_DOUBLE_EQ(apart(1), 1);
}

/// Bars, leaflets, phases and sounds follow from these.
TEST(ValveState, OpenTimesAreTheSamplesThatAreOpenInEveryScenario) {
  for (const Scenario& scenario : scenarios()) {
    const Solved solved = solve(scenario.id);
    const Beat& beat = solved.state.beat;
    for (std::size_t v = 0; v < kValves; ++v) {
      const auto valve = static_cast<Valve>(v);
      const auto times = openTimes(beat, valve);
      for (std::size_t i = 0; i + 1 < beat.time.size(); ++i) {
        const bool open = std::any_of(times.begin(), times.end(),
                                      [&](const ValveTimes& t) { return within(t, beat.time[i]); });
        ASSERT_EQ(open, isOpen(beat.open[v][i])) << scenario.id << ' ' << nameOf(valve) << ' ' << i;
        ASSERT_EQ(open, apart(beat.open[v][i]) > 0);
      }
    }
  }
}

TEST(ValveState, EjectionAndIsovolumicTimesLieBetweenTheValvesTimesInEveryScenario) {
  for (const Scenario& scenario : scenarios()) {
    const Solved solved = solve(scenario.id);
    const Indices& at = solved.indices;
    const auto &mitral = at.valves[0], &aortic = at.valves[1];
    ASSERT_TRUE(mitral && aortic) << scenario.id;
    EXPECT_DOUBLE_EQ(at.ejectionSeconds, openSeconds(*aortic, solved.state.beat.period)) << scenario.id;
    EXPECT_NEAR(at.isovolumicContractionSeconds + at.ejectionSeconds + at.isovolumicRelaxationSeconds +
                    openSeconds(*mitral, solved.state.beat.period),
                solved.state.beat.period, 1e-9)
        << scenario.id;
    for (const HeartSound& sound : heartSounds(solved.parameters, solved.state.beat, at)) {
      if (sound.name == "S1 mitral") {
        EXPECT_EQ(sound.seconds, mitral->shuts) << scenario.id;
      }
      if (sound.name == "S2 aortic") {
        EXPECT_EQ(sound.seconds, aortic->shuts) << scenario.id;
      }
    }
  }
}

TEST(ValveState, TimeBetweenTwoValvesIsNoneWhereTheSecondOpensFirst) {
  EXPECT_NEAR(bothShutSeconds({0.5, 0.02}, {0.07, 0.35}, 0.8), 0.05, 1e-12);
  EXPECT_NEAR(bothShutSeconds({0.5, 0.79}, {0.07, 0.35}, 0.8), 0.08, 1e-12);
  EXPECT_EQ(bothShutSeconds({0.5, 0.08}, {0.07, 0.35}, 0.8), 0);
}

/// Neither P, QRS nor T lies across the ends of what is drawn.
TEST(ValveState, DrawnBeatBeginsBeforePAndEndsAfterTAtEveryRate) {
  constexpr double kBeforeAtria = 0.08;
  for (double rate = 40; rate <= 200; rate += 10) {
    Parameters parameters;
    parameters.rate = rate;
    if (rate > 110)
      parameters.conduction = 0.095;
    const double begins = -conductionSeconds(parameters) - kBeforeAtria;
    for (const double aside : {-0.002, 0.0, 0.002})
      EXPECT_LT(std::abs(electrocardiogram(parameters, begins + aside)), 0.035) << rate;
  }
}

TEST(ValveState, DrawnCurvesAreTheSolvedOnesFromAnotherInstantOn) {
  const Solved rest = solve("rest");
  const Beat& beat = rest.state.beat;
  const std::size_t first = firstDrawn(rest.parameters, beat, 0.08);
  EXPECT_NEAR(beat.time[first], beat.period - rest.parameters.conduction - 0.08, 1e-3);
  const auto drawn = drawnFrom(first, beat.pressureOf(Compartment::lv));
  ASSERT_EQ(drawn.size(), beat.time.size());
  EXPECT_EQ(drawn.front(), beat.pressureOf(Compartment::lv)[first]);
  EXPECT_EQ(drawn.back(), drawn.front());
  EXPECT_EQ(
      *std::max_element(drawn.begin(), drawn.end()),
      *std::max_element(beat.pressureOf(Compartment::lv).begin(), beat.pressureOf(Compartment::lv).end()));
}

} // namespace
} // namespace viscera::circulation
