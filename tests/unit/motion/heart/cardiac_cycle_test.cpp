#include "viscera/heart/cardiac_cycle.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/heart/heart_valves.h"

namespace viscera::heart {
namespace {

std::vector<double> allRates() {
  std::vector<double> rates;
  for (double rate = CardiacCycle::kLowestRateBpm; rate <= CardiacCycle::kHighestRateBpm; rate += 2.5)
    rates.push_back(rate);
  return rates;
}

double systoleByDiastole(double rate) {
  const CardiacTimes times = cardiacTimes(rate);
  return times.systole() / times.diastole();
}

TEST(CardiacTimes, EjectionFollowsTheRegressionsOfRestAndExerciseWithinTenMilliseconds) {
  EXPECT_NEAR(cardiacTimes(50).ejection, 0.328, 0.010);
  EXPECT_NEAR(cardiacTimes(75).ejection, 0.2855, 0.010);
  EXPECT_NEAR(cardiacTimes(100).ejection, 0.251, 0.010);
  EXPECT_NEAR(cardiacTimes(150).ejection, 0.191, 0.010);
  EXPECT_NEAR(cardiacTimes(171).ejection, 0.1658, 0.010);
  for (const double rate : allRates())
    EXPECT_GE(cardiacTimes(rate).ejection, 0.130 - 1e-12) << rate;
}

TEST(CardiacTimes, SystoleByDiastoleAt100IsThatOfHealthyPeople) {
  EXPECT_NEAR(systoleByDiastole(100), 0.74, 0.12);
}

TEST(CardiacTimes, SystoleShortensByAThirdFrom75To150AndDiastoleByFarMore) {
  const CardiacTimes slow = cardiacTimes(75);
  const CardiacTimes fast = cardiacTimes(150);
  EXPECT_NEAR(fast.systole() / slow.systole(), 0.67, 0.03);
  EXPECT_LT(fast.diastole() / slow.diastole(), 0.4);
}

TEST(CardiacTimes, WavesOfFillingShortenBy18And16PerCentAtTwiceTheRate) {
  for (const double rate : {40.0, 50.0, 60.0}) {
    EXPECT_NEAR(cardiacTimes(2 * rate).earlyFilling / cardiacTimes(rate).earlyFilling, 0.82, 1e-9) << rate;
    EXPECT_NEAR(cardiacTimes(2 * rate).atrialSystole / cardiacTimes(rate).atrialSystole, 0.84, 1e-9) << rate;
  }
}

TEST(CardiacTimes, DiastasisVanishesFirstThenTheWavesOverlap) {
  double before = cardiacTimes(CardiacCycle::kLowestRateBpm).diastasis();
  for (const double rate : allRates()) {
    const CardiacTimes times = cardiacTimes(rate);
    EXPECT_LE(times.diastasis(), before) << rate;
    EXPECT_EQ(times.diastasis() * times.overlap(), 0) << rate;
    before = times.diastasis();
  }
  EXPECT_GT(cardiacTimes(75).diastasis(), 0.05);
  EXPECT_EQ(cardiacTimes(100).diastasis(), 0);
  EXPECT_GT(cardiacTimes(100).overlap(), 0);
  EXPECT_GT(cardiacTimes(120).overlap(), cardiacTimes(100).overlap());
}

TEST(CardiacTimes, PartsLastAsMeasuredInHealthyAdultsAtRest) {
  const CardiacTimes times = cardiacTimes(65);
  EXPECT_NEAR(times.isovolumicContraction, 0.040, 0.010);
  EXPECT_NEAR(times.ejection, 0.292, 0.023);
  EXPECT_NEAR(times.isovolumicRelaxation, 0.096, 0.019);
  EXPECT_NEAR(cardiacTimes(150).isovolumicContraction, 0.025, 1e-9);
  EXPECT_NEAR(cardiacTimes(65 * 1.85).isovolumicRelaxation / times.isovolumicRelaxation, 0.46, 1e-9);
}

TEST(CardiacTimes, EveryPartHasItsPlaceInTheBeatAtEveryRate) {
  for (const double rate : allRates()) {
    const CardiacTimes t = cardiacTimes(rate);
    for (const double part :
         {t.atrialSystole, t.isovolumicContraction, t.ejection, t.isovolumicRelaxation, t.earlyFilling})
      EXPECT_GT(part, 0.02) << rate;
    EXPECT_LE(t.earlyFilling, t.filling() + 1e-12) << rate;
    EXPECT_LT(t.atrialSystole, t.filling()) << rate;
    EXPECT_NEAR(t.systole() + t.isovolumicRelaxation + t.earlyFilling + t.diastasis() + t.atrialSystole -
                    t.overlap(),
                60 / rate, 1e-12);
  }
}

TEST(CardiacTimes, ValvesOfTheRightHeartRestForAShorterTimeAndMoveInTheirOrder) {
  for (const double rate : allRates()) {
    const VentricleClock left = leftClock(cardiacTimes(rate));
    const VentricleClock right = rightClock(cardiacTimes(rate));
    EXPECT_LT(right.isovolumicContraction(), 0.6 * left.isovolumicContraction()) << rate;
    EXPECT_LT(right.isovolumicRelaxation(), 0.6 * left.isovolumicRelaxation()) << rate;
    EXPECT_GT(right.inletShuts, left.inletShuts) << rate;
    EXPECT_LT(right.outletOpens, left.outletOpens) << rate;
    EXPECT_GT(right.outletShuts, left.outletShuts) << rate;
    EXPECT_LT(right.inletOpens, left.inletOpens) << rate;
  }
}

TEST(CardiacCycle, LeftVentricleEmptiesFrom130To55MillilitresAndEjects58PerCent) {
  const CardiacBeat beat = CardiacCycle().beat(75);
  double most = 0;
  double least = 1e9;
  for (int k = 0; k < 2000; ++k) {
    const double volume = beat.at(k * 0.8 / 2000).volumes.leftMl;
    most = std::max(most, volume);
    least = std::min(least, volume);
  }
  EXPECT_NEAR(most, 130.5, 1e-9);
  EXPECT_NEAR(least, 55, 1e-9);
  EXPECT_NEAR((most - least) / most, 0.58, 0.005);
}

TEST(CardiacCycle, BothVentriclesEjectTheSameVolumeAtEveryRate) {
  const CardiacCycle cycle;
  for (const double rate : allRates()) {
    const CardiacBeat beat = cycle.beat(rate);
    const auto strokeOf = [&](double CavityVolumes::*side, const VentricleClock& clock) {
      return beat.at(clock.outletOpens).volumes.*side - beat.at(clock.outletShuts).volumes.*side;
    };
    EXPECT_NEAR(strokeOf(&CavityVolumes::leftMl, beat.left()),
                strokeOf(&CavityVolumes::rightMl, beat.right()), 1e-9)
        << rate;
  }
}

TEST(CardiacCycle, StrokeVolumeFallsOnlyWhereFillingNoLongerSuffices) {
  const CardiacCycle cycle;
  EXPECT_EQ(cycle.beat(50).strokePart(), 1);
  EXPECT_EQ(cycle.beat(140).strokePart(), 1);
  EXPECT_NEAR(cycle.beat(150).strokePart(), 0.93, 0.02);
  double before = 1;
  for (const double rate : {150.0, 171.0, 190.0, 220.0}) {
    EXPECT_LT(cycle.beat(rate).strokePart(), before);
    before = cycle.beat(rate).strokePart();
  }
  EXPECT_GT(before, 0.5);
}

TEST(CardiacCycle, PeakFlowsAtRestAreThoseOfPeople) {
  const CardiacBeat beat = CardiacCycle().beat(75);
  double out = 0, in = 0;
  for (double t = 0; t < 0.8; t += 1e-3) {
    const double flow = (beat.at(t + 1e-3).volumes.leftMl - beat.at(t).volumes.leftMl) / 1e-3;
    out = std::max(out, -flow);
    in = std::max(in, flow);
  }
  EXPECT_NEAR(out, 500, 60);
  EXPECT_NEAR(in, 500, 60);
}

TEST(CardiacCycle, VolumesRestBetweenTheValves) {
  const CardiacCycle cycle;
  for (const double rate : {20.0, 75.0, 150.0, 220.0}) {
    const CardiacBeat beat = cycle.beat(rate);
    for (const double part : {0.0, 0.3, 1.0}) {
      const VentricleClock& c = beat.left();
      EXPECT_NEAR(beat.at(c.inletShuts + part * c.isovolumicContraction()).leftEmptying,
                  1 - beat.strokePart(), 1e-9);
      EXPECT_NEAR(beat.at(c.outletShuts + part * c.isovolumicRelaxation()).leftEmptying, 1, 1e-9);
      const VentricleClock& r = beat.right();
      EXPECT_NEAR(beat.at(r.inletShuts + part * r.isovolumicContraction()).rightEmptying,
                  1 - beat.strokePart(), 1e-9);
      EXPECT_NEAR(beat.at(r.outletShuts + part * r.isovolumicRelaxation()).rightEmptying, 1, 1e-9);
    }
  }
}

TEST(CardiacCycle, AtriaContractBeforeTheVentriclesAndTwistPeaksAtTheEndOfEjection) {
  const CardiacBeat beat = CardiacCycle().beat(75);
  const VentricleClock& clock = beat.left();
  EXPECT_NEAR(beat.at(kBeforeAtria + 0.64 * beat.times().atrialSystole).atrialContraction, 1, 1e-9);
  EXPECT_EQ(beat.at(clock.outletShuts).atrialContraction, 0);
  EXPECT_LT(beat.at(clock.outletOpens).twist, 0);
  EXPECT_NEAR(beat.at(clock.outletOpens + 0.933 * beat.times().ejection).twist, 1, 1e-9);
  EXPECT_NEAR(beat.at(0.75 + kBeforeAtria).twist, 0, 1e-9);
}

/// The numbers of an instant that are drawn or move handles.
std::vector<double> numbersOf(const CardiacInstant& now) {
  return {now.leftEmptying, now.rightEmptying, now.twist, now.atrialContraction};
}

TEST(CardiacCycle, RunsWithoutJumpsAndKinksAndRepeatsWithTheBeat) {
  const CardiacCycle cycle;
  constexpr double kStep = 1e-6;
  for (const double rate : {20.0, 50.0, 75.0, 92.5, 100.0, 150.0, 220.0}) {
    const CardiacBeat beat = cycle.beat(rate);
    for (int k = 0; k < 700; ++k) {
      const double t = k * beat.times().cycle / 700;
      const auto before = numbersOf(beat.at(t - kStep)), now = numbersOf(beat.at(t)),
                 after = numbersOf(beat.at(t + kStep));
      const auto later = numbersOf(beat.at(t + 3 * beat.times().cycle));
      for (std::size_t i = 0; i < now.size(); ++i) {
        EXPECT_NEAR((now[i] - before[i]) / kStep, (after[i] - now[i]) / kStep, 0.05) << rate << ' ' << t;
        EXPECT_NEAR(now[i], later[i], 1e-9) << rate << ' ' << t;
      }
    }
  }
}

TEST(CardiacCycle, DependsContinuouslyOnTheRate) {
  const CardiacCycle cycle;
  for (const double rate : allRates())
    for (int k = 0; k < 20; ++k) {
      const double fraction = k / 20.0;
      const auto here = numbersOf(cycle.at(fraction * 60 / rate, rate));
      const auto there = numbersOf(cycle.at(fraction * 60 / (rate + 1e-4), rate + 1e-4));
      for (std::size_t i = 0; i < here.size(); ++i)
        EXPECT_NEAR(here[i], there[i], 1e-4) << rate;
    }
}

/// A beat begins before the atria contract, within the part with which the one before ended.
TEST(CardiacCycle, NamesItsPhasesInOrderAndWithoutGaps) {
  const std::vector<std::string> names{"atrial systole",   "isovolumic contraction", "rapid ejection",
                                       "reduced ejection", "isovolumic relaxation",  "rapid filling",
                                       "diastasis"};
  for (const double rate : allRates()) {
    const std::vector<sequences::Phase> phases = CardiacCycle::phases(rate);
    ASSERT_EQ(phases.size(), cardiacTimes(rate).diastasis() > 0 ? 8u : 7u) << rate;
    EXPECT_EQ(phases.front().name.english(), phases.back().name.english());
    double end = 0;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      EXPECT_EQ(phases[i].begin, end);
      EXPECT_GT(phases[i].end, phases[i].begin);
      EXPECT_EQ(phases[i].group, phases[i].name.english().find("ejection") != std::string::npos ||
                                         phases[i].name == "isovolumic contraction"
                                     ? "systole"
                                     : "diastole");
      end = phases[i].end;
    }
    EXPECT_EQ(end, 1);
    const auto atria = std::find_if(phases.begin(), phases.end(),
                                    [](const auto& phase) { return phase.name == "atrial systole"; });
    ASSERT_NE(atria, phases.end());
    EXPECT_NEAR(atria->begin * 60 / rate, kBeforeAtria, 1e-12);
    std::vector<sequences::Phase> following(phases.begin(),
                                            phases.end() - 1); // The last goes on in the first.
    std::rotate(following.begin(), following.begin() + (atria - phases.begin()), following.end());
    for (std::size_t i = 0; i < following.size(); ++i)
      EXPECT_EQ(following[i].name.english(), names[i]) << rate;
  }
}

TEST(CardiacCycle, TwoThirdsOfTheStrokeLeaveInTheRapidEjection) {
  const CardiacBeat beat = CardiacCycle().beat(75);
  for (const sequences::Phase& phase : CardiacCycle::phases(75)) {
    if (phase.name == "rapid ejection") {
      EXPECT_NEAR(beat.at(phase.end * 0.8).leftEmptying, 0.67, 0.03);
    }
    if (phase.name == "reduced ejection") {
      EXPECT_NEAR(beat.at(phase.end * 0.8).leftEmptying, 1, 1e-9);
    }
  }
}

/// The bars of open valves, the phases and the leaflets.
TEST(CardiacCycle, ValvesAreOpenJustBetweenTheTimesOfTheirClockAtEveryRate) {
  for (const double rate : allRates()) {
    const CardiacBeat beat = CardiacCycle().beat(rate);
    const double cycle = beat.times().cycle;
    const auto inside = [&](double t, double opens, double shuts) {
      const double since = t - opens - cycle * std::floor((t - opens) / cycle);
      return since < shuts - opens - cycle * std::floor((shuts - opens) / cycle);
    };
    for (int k = 0; k < 500; ++k) {
      const double t = (k + 0.4567) * cycle / 500; // Apart from every instant of a clock.
      const ValveInstants valves = textbookValves(beat, t);
      const VentricleClock &left = beat.left(), &right = beat.right();
      EXPECT_EQ(valves[0].areaMm2 > 0, inside(t, left.inletOpens, left.inletShuts)) << rate << ' ' << t;
      EXPECT_EQ(valves[1].areaMm2 > 0, inside(t, left.outletOpens, left.outletShuts)) << rate << ' ' << t;
      EXPECT_EQ(valves[2].areaMm2 > 0, inside(t, right.inletOpens, right.inletShuts)) << rate << ' ' << t;
      EXPECT_EQ(valves[3].areaMm2 > 0, inside(t, right.outletOpens, right.outletShuts)) << rate << ' ' << t;
    }
  }
}

TEST(CardiacCycle, OfAnotherHeartReachesItsOwnVolumes) {
  const CardiacBeat beat = CardiacCycle({160, 170}, {60, 80}).beat(60);
  const CavityVolumes full = beat.at(beat.left().outletOpens - 0.01).volumes;
  EXPECT_NEAR(full.leftMl, 160, 1e-9);
  EXPECT_NEAR(beat.at(beat.right().outletOpens).volumes.rightMl, 170, 1e-9);
  EXPECT_NEAR(beat.at(beat.left().outletShuts + 0.01).volumes.leftMl, 60, 1e-9);
  EXPECT_NEAR(beat.at(beat.right().outletShuts).volumes.rightMl, 80, 1e-9);
  EXPECT_THROW(CardiacCycle({100, 100}, {110, 50}), DataError);
  EXPECT_THROW(CardiacCycle({100, 100}, {50, 0}), DataError);
}

} // namespace
} // namespace viscera::heart
