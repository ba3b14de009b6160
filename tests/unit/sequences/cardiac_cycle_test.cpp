#include "viscera/sequences/cardiac_cycle.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

std::vector<double> allRates() {
  std::vector<double> rates;
  for (double rate = CardiacCycle::kLowestRateBpm; rate <= CardiacCycle::kHighestRateBpm; rate += 2.5)
    rates.push_back(rate);
  return rates;
}

TEST(CardiacCycle, leftVentricleEmptiesFrom130To55MillilitresAndEjects58PerCent) {
  const CardiacCycle cycle;
  double most = 0;
  double least = 1e9;
  for (int k = 0; k < 2000; ++k) {
    const double volume = cycle.volumes(k / 2000.0).leftMl;
    most = std::max(most, volume);
    least = std::min(least, volume);
  }
  EXPECT_NEAR(most, 130.5, 1e-9);
  EXPECT_NEAR(least, 55, 1e-9);
  EXPECT_NEAR((most - least) / most, 0.58, 0.005);
}

TEST(CardiacCycle, rightVentricleFollowsACurveOfTheSameShape) {
  const CardiacCycle cycle;
  for (int k = 0; k < 100; ++k) {
    const CavityVolumes volumes = cycle.volumes(k / 100.0);
    EXPECT_NEAR((volumes.rightMl - 66) / (138 - 66), (volumes.leftMl - 55) / (130.5 - 55), 1e-12);
  }
}

TEST(CardiacCycle, volumesRestBetweenTheValves) {
  const CardiacCycle cycle;
  for (const double phase : {0.11, 0.13, 0.15, 0.17})
    EXPECT_NEAR(cycle.emptying(phase), 0, 1e-12) << phase;
  for (const double phase : {0.47, 0.49, 0.52, 0.54})
    EXPECT_NEAR(cycle.emptying(phase), 1, 1e-12) << phase;
}

TEST(CardiacCycle, everyCurveJoinsAtTheEndOfTheBeat) {
  const CardiacCycle cycle;
  EXPECT_NEAR(cycle.volumes(1 - 1e-9).leftMl, cycle.volumes(0).leftMl, 1e-6);
  EXPECT_NEAR(cycle.twist(1 - 1e-9), cycle.twist(0), 1e-6);
  EXPECT_NEAR(cycle.atrialContraction(1 - 1e-9), cycle.atrialContraction(0), 1e-6);
  EXPECT_NEAR(cycle.emptying(3.3), cycle.emptying(0.3), 1e-12);
}

TEST(CardiacCycle, atriaContractBeforeTheVentriclesAndTwistPeaksAtTheEndOfEjection) {
  const CardiacCycle cycle;
  EXPECT_EQ(cycle.atrialContraction(0.07), 1);
  EXPECT_EQ(cycle.atrialContraction(0.4), 0);
  EXPECT_LT(cycle.twist(0.17), 0);
  EXPECT_EQ(cycle.twist(0.45), 1);
  EXPECT_EQ(cycle.twist(0.9), 0);
}

TEST(CardiacCycle, systoleTakes300To330MillisecondsAt50And75And150) {
  for (const double rate : {50.0, 75.0, 150.0}) {
    const double systole = CardiacCycle::times(rate).systole();
    EXPECT_GE(systole, 0.30) << rate;
    EXPECT_LE(systole, 0.33) << rate;
  }
}

TEST(CardiacCycle, systoleIsReadOffTheVolumeCurveAsWell) {
  const CardiacCycle cycle;
  for (const double rate : {50.0, 75.0, 150.0}) {
    double begin = -1;
    double end = -1;
    for (double t = 0; t < 60 / rate; t += 1e-4) {
      const double phase = cycle.referencePhase(t, rate);
      if (begin < 0 && phase >= 0.11)
        begin = t;
      if (end < 0 && phase > 0.15 && cycle.emptying(phase) > 1 - 1e-9)
        end = t;
    }
    EXPECT_NEAR(end - begin, CardiacCycle::times(rate).systole(), 1e-3) << rate;
  }
}

TEST(CardiacCycle, partsOfTheBeatLastAsMeasuredInHealthyAdultsAtRest) {
  const CardiacTimes times = CardiacCycle::times(65);
  EXPECT_NEAR(times.isovolumicContraction, 0.040, 0.010);
  EXPECT_NEAR(times.ejection, 0.292, 0.023);
  EXPECT_NEAR(times.isovolumicRelaxation, 0.096, 0.019);
}

TEST(CardiacCycle, partsAddUpToTheBeatAtEveryRateAndNoneVanishes) {
  for (const double rate : allRates()) {
    const CardiacTimes t = CardiacCycle::times(rate);
    EXPECT_NEAR(t.cycle(), 60 / rate, 1e-12);
    for (const double part : {t.atrialSystole, t.isovolumicContraction, t.ejection, t.isovolumicRelaxation,
                              t.rapidFilling, t.diastasis})
      EXPECT_GT(part, 0.004 * 60 / rate) << rate;
  }
}

TEST(CardiacCycle, diastoleStretchesMoreThanSystoleAsTheHeartSlows) {
  const CardiacTimes slow = CardiacCycle::times(50);
  const CardiacTimes fast = CardiacCycle::times(150);
  EXPECT_LT(slow.systole() / fast.systole(), 1.1);
  EXPECT_GT((slow.cycle() - slow.systole()) / (fast.cycle() - fast.systole()), 8);
  EXPECT_GT(slow.diastasis, slow.rapidFilling);
}

TEST(CardiacCycle, phaseAscendsStrictlyAndGainsOneABeatAtEveryRate) {
  const CardiacCycle cycle;
  for (const double rate : allRates()) {
    const double beat = 60 / rate;
    double before = cycle.referencePhase(0, rate);
    EXPECT_NEAR(before, 0, 1e-12);
    for (int k = 1; k <= 400; ++k) {
      const double now = cycle.referencePhase(k * beat / 400, rate);
      EXPECT_GT(now, before) << rate;
      EXPECT_LT(now - before, 0.05) << "a jump at " << rate;
      before = now;
    }
    EXPECT_NEAR(before, 1, 1e-9);
    EXPECT_NEAR(cycle.referencePhase(7.3 * beat, rate), cycle.referencePhase(0.3 * beat, rate) + 7, 1e-9);
  }
}

TEST(CardiacCycle, phaseRunsWithoutKinksInTime) {
  const CardiacCycle cycle;
  constexpr double kStep = 1e-6;
  for (const double rate : {30.0, 75.0, 150.0, 220.0}) {
    const double beat = 60 / rate;
    for (int k = 0; k < 500; ++k) {
      const double t = k * beat / 500;
      const double left = cycle.referencePhase(t, rate) - cycle.referencePhase(t - kStep, rate);
      const double right = cycle.referencePhase(t + kStep, rate) - cycle.referencePhase(t, rate);
      EXPECT_NEAR(left / kStep, right / kStep, 0.05) << rate << " " << t;
    }
  }
}

TEST(CardiacCycle, phaseDependsContinuouslyOnTheRate) {
  const CardiacCycle cycle;
  for (const double rate : allRates())
    for (int k = 0; k < 20; ++k) {
      const double fraction = k / 20.0;
      EXPECT_NEAR(cycle.referencePhase(fraction * 60 / rate, rate),
                  cycle.referencePhase(fraction * 60 / (rate + 1e-4), rate + 1e-4), 1e-4);
    }
}

TEST(CardiacCycle, namesItsPhasesInOrderAndWithoutGaps) {
  const std::vector<std::string> names{"atrial systole", "isovolumic contraction", "ejection",
                                       "isovolumic relaxation", "filling"};
  const std::vector<double> ends{0.11, 0.17, 0.47, 0.54, 1.0};
  const CardiacCycle cycle;
  for (const double rate : {20.0, 75.0, 220.0}) {
    const std::vector<Phase> phases = CardiacCycle::phases(rate);
    ASSERT_EQ(phases.size(), names.size());
    double end = 0;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      EXPECT_EQ(phases[i].name, names[i]);
      EXPECT_EQ(phases[i].begin, end);
      end = phases[i].end;
      EXPECT_NEAR(cycle.referencePhase(end * 60 / rate - 1e-12, rate), ends[i], 1e-6);
    }
    EXPECT_EQ(end, 1);
  }
}

TEST(CardiacCycle, ofAnotherHeartReachesItsOwnVolumes) {
  const CardiacCycle cycle({160, 170}, {60, 80});
  EXPECT_NEAR(cycle.volumes(0.15).leftMl, 160, 1e-9);
  EXPECT_NEAR(cycle.volumes(0.15).rightMl, 170, 1e-9);
  EXPECT_NEAR(cycle.volumes(0.5).leftMl, 60, 1e-9);
  EXPECT_NEAR(cycle.volumes(0.5).rightMl, 80, 1e-9);
  EXPECT_THROW(CardiacCycle({100, 100}, {110, 50}), DataError);
  EXPECT_THROW(CardiacCycle({100, 100}, {50, 0}), DataError);
}

} // namespace
} // namespace viscera::sequences
