#include "viscera/sequences/gastric_waves.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

const GastricWaves kWaves;

TEST(GastricWaves, takeAboutAMinuteSoThatThreeAreOnTheirWay) {
  EXPECT_GE(kWaves.transitSeconds(), 55);
  EXPECT_LE(kWaves.transitSeconds(), 65);
  double sum = 0;
  for (double t = 0; t < 20; t += 0.5) {
    const std::size_t count = kWaves.positions(t, 3).size();
    EXPECT_GE(count, 3u) << t;
    EXPECT_LE(count, 4u) << t;
    sum += static_cast<double>(count) / 40;
  }
  EXPECT_NEAR(sum, 3, 0.4);
}

TEST(GastricWaves, runFromTheBodyToThePylorusAtOneSpeedAndGainDepth) {
  EXPECT_NEAR(kWaves.position(0), kWaves.course().midBody, 1e-9);
  const double end = kWaves.transitSeconds();
  EXPECT_NEAR(kWaves.position(end), kWaves.course().pylorus, 1e-9);
  for (double age = 6; age < end - 1; age += 1) {
    EXPECT_NEAR(kWaves.position(age + 1) - kWaves.position(age), 2.7, 1e-9);
    EXPECT_GT(kWaves.depth(age + 1), kWaves.depth(age));
  }
}

TEST(GastricWaves, deepestOcclusionIsThatMeasuredInPeople) {
  double deepest = 0;
  for (double age = 0; age < 70; age += 0.1)
    deepest = std::max(deepest, kWaves.depth(age));
  EXPECT_NEAR(deepest, 0.58, 0.14);
}

TEST(GastricWaves, findThePylorusShutBeforeTheyComeToItAndLeaveItOpen) {
  const double pylorus = kWaves.course().pylorus;
  bool opened = false;
  for (double t = 0; t < 20; t += 0.25) {
    const std::vector<double> places = kWaves.positions(t, 3);
    const double left = pylorus - places.front();
    const double closure = kWaves.pyloricClosure(t, 3);
    if (left > 0 && left <= 14) {
      EXPECT_NEAR(closure, 1, 1e-9) << left << " mm before it";
    }
    if (left > 28 && left < 42) {
      EXPECT_EQ(closure, 0) << left << " mm before it";
    }
    opened = opened || closure == 0;
    EXPECT_GE(kWaves.constriction(pylorus, t, 3), 0.6 * closure - 1e-9);
  }
  EXPECT_TRUE(opened);
}

TEST(GastricWaves, ratesThatHealthyPeopleDoNotHaveAreNamed) {
  for (const double rate : {2.0, 3.0, 4.0})
    EXPECT_TRUE(GastricWaves::rateRemark(rate).empty()) << rate;
  EXPECT_EQ(GastricWaves::rateRemark(1.9).english().find("Bradygastria"), 0u);
  EXPECT_EQ(GastricWaves::rateRemark(4.1).english().find("Tachygastria"), 0u);
}

TEST(GastricWaves, formAndFadeWithoutAJump) {
  EXPECT_EQ(kWaves.depth(-3), 0);
  EXPECT_NEAR(kWaves.depth(kWaves.transitSeconds() + 4), 0, 1e-12);
  for (double t = -5; t < 75; t += 0.01)
    for (const double s : {90.0, 150.0, 230.0, 268.0})
      EXPECT_NEAR(kWaves.constriction(s, t, 3), kWaves.constriction(s, t + 1e-3, 3), 2e-3);
}

TEST(GastricWaves, repeatAtEveryRateAndAriseMoreOftenAtHigherOnes) {
  for (const double rate : {1.0, 2.7, 3.0, 6.0})
    for (double t = 0; t < 60; t += 3.7)
      EXPECT_NEAR(kWaves.constriction(200, t, rate), kWaves.constriction(200, t + 5 * 60 / rate, rate), 1e-9);
  EXPECT_LE(kWaves.positions(10, 1).size(), 2u);
  EXPECT_GE(kWaves.positions(10, 6).size(), 6u);
}

TEST(GastricWaves, leaveTheFundusAloneAndNeverCloseTheStomach) {
  for (const double rate : {1.0, 3.0, 6.0})
    for (double t = 0; t < 60; t += 0.5) {
      EXPECT_LT(kWaves.constriction(20, t, rate), 1e-3);
      for (double s = 0; s < 300; s += 4)
        EXPECT_LT(kWaves.constriction(s, t, rate), 0.75);
    }
}

TEST(GastricWaves, namesWhereTheOldestWaveIs) {
  for (const double rate : {1.0, 3.0, 6.0}) {
    const std::vector<Phase> phases = kWaves.phases(rate);
    double end = 0;
    for (const Phase& phase : phases) {
      EXPECT_EQ(phase.begin, end);
      EXPECT_GT(phase.end, phase.begin);
      end = phase.end;
    }
    EXPECT_EQ(end, 1);
    EXPECT_TRUE(std::any_of(phases.begin(), phases.end(), [](const Phase& phase) {
      return phase.name.english() == "terminal antral contraction";
    }));
  }
}

TEST(GastricWaves, travelFromTheBodyToThePylorusAsMarksOfTheTimeline) {
  const GastricWaves waves;
  const std::vector<NamedPlace> places = waves.places();
  ASSERT_EQ(places.size(), 4u);
  EXPECT_EQ(places.front().name, "fundus");
  EXPECT_EQ(places.front().place, 0);
  EXPECT_EQ(places.back().name, "pylorus");
  EXPECT_EQ(places.back().place, 1);
  for (double seconds = 0; seconds < 20; seconds += 0.5) {
    const std::vector<double> positions = waves.positions(seconds, 3);
    const std::vector<TravellingMark> marks = waves.travelling(seconds, 3);
    ASSERT_EQ(marks.size(), positions.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      EXPECT_NEAR(marks[i].place * waves.course().pylorus, positions[i], 1e-9);
      EXPECT_GT(marks[i].strength, 0);
      EXPECT_LE(marks[i].strength, 1);
    }
  }
}

TEST(GastricWaves, refuseACourseThatRunsBackwards) {
  EXPECT_THROW(GastricWaves(GastricCourse{200, 100}), DataError);
}

} // namespace
} // namespace viscera::sequences
