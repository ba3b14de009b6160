#include <algorithm>
#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solved.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/signs.h"

namespace viscera::circulation {
namespace {

std::optional<HeartSound> soundOf(const Solved& solved, const std::string& name) {
  for (const HeartSound& sound : heartSounds(solved.parameters, solved.state.beat, solved.indices))
    if (sound.name == name)
      return sound;
  return std::nullopt;
}

double loudest(const Solved& solved, double from, double to) {
  const auto curve = phonocardiogram(solved.parameters, solved.state.beat, solved.indices);
  double top = 0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (solved.state.beat.time[i] >= from && solved.state.beat.time[i] < to)
      top = std::max(top, std::abs(curve[i]));
  return top;
}

} // namespace

TEST(CirculationSigns, ElectrocardiogramLeadsTheHeartAndRepeats) {
  const Parameters rest;
  const double period = 60 / rest.rate;
  double top = 0, when = 0;
  for (double t = 0; t < period; t += 0.001)
    if (electrocardiogram(rest, t) > top) {
      top = electrocardiogram(rest, t);
      when = t;
    }
  EXPECT_NEAR(top, 1.1, 0.05);
  EXPECT_NEAR(when, period - 0.03, 0.003);
  EXPECT_NEAR(electrocardiogram(rest, 0.1), electrocardiogram(rest, 0.1 + 3 * period), 1e-12);
  // P before the atria, T before the end of systole.
  EXPECT_GT(electrocardiogram(rest, -rest.conduction - 0.01), 0.14);
  EXPECT_GT(electrocardiogram(rest, 0.8 * endSystoleSeconds(rest.rate) - 0.03), 0.28);
}

TEST(CirculationSigns, TheExcitationIsWhereTheElectrocardiogramIs) {
  Parameters slow;
  slow.conduction = 0.22;
  for (const Parameters& parameters : {Parameters(), slow}) {
    const Excitation at = excitationOf(parameters);
    const auto seen = [&](double from, double to) {
      double most = 0;
      for (double t = from; t < to; t += 1e-3)
        most = std::max(most, std::abs(electrocardiogram(parameters, t)));
      return most;
    };
    EXPECT_GT(seen(at.sinusNode, at.atriaDone), 0.14) << "P";
    EXPECT_LT(seen(at.atriaDone + 0.004, at.ventriclesBegin - 0.004), 0.02) << "the segment behind it";
    EXPECT_GT(seen(at.ventriclesBegin, at.ventriclesDone), 1) << "QRS";
    EXPECT_EQ(excitationMs(parameters, at.sinusNode), 0);
    EXPECT_NEAR(excitationMs(parameters, at.atriaDone), kAtriaDoneMs, 2);
    EXPECT_NEAR(excitationMs(parameters, at.ventriclesBegin), kVentriclesBeginMs, 1e-9);
    EXPECT_NEAR(excitationMs(parameters, at.ventriclesDone), kVentriclesDoneMs, 1e-9);
    EXPECT_NEAR(excitationMs(parameters, at.ventriclesDone + 0.1), kVentriclesDoneMs + 100, 1e-6);
  }
}

TEST(CirculationSigns, TheExcitationRunsOnAndRepeatsAtEveryRate) {
  for (const double rate : {40.0, 72.0, 150.0, 200.0}) {
    Parameters parameters;
    parameters.rate = rate;
    const double period = 60 / rate, begin = excitationOf(parameters).sinusNode;
    double before = -1;
    for (double t = begin + 1e-6; t < begin + period; t += 1e-3) {
      const double now = excitationMs(parameters, t);
      EXPECT_GE(now, before) << rate << " a minute, " << t;
      EXPECT_NEAR(now, excitationMs(parameters, t + 3 * period), 1e-6);
      before = now;
    }
  }
}

TEST(CirculationSigns, FirstSoundsComeWithTheAtrialValvesAndSecondOnesWithTheArterial) {
  const Solved rest = solve("rest");
  const auto mitral = soundOf(rest, "S1 mitral"), tricuspid = soundOf(rest, "S1 tricuspid");
  const auto aortic = soundOf(rest, "S2 aortic"), pulmonic = soundOf(rest, "S2 pulmonic");
  ASSERT_TRUE(mitral && tricuspid && aortic && pulmonic);
  EXPECT_EQ(mitral->seconds, rest.indices.valves[0]->shuts);
  EXPECT_EQ(aortic->seconds, rest.indices.valves[1]->shuts);
  EXPECT_LT(aortic->seconds, pulmonic->seconds); // A2 before P2.
  EXPECT_GT(aortic->loudness, pulmonic->loudness);
  EXPECT_NEAR(mitral->loudness, 1, 0.2);
}

TEST(CirculationSigns, ThirdAndFourthSoundsAreThoseOfFailingAndStiffHearts) {
  const Solved rest = solve("rest");
  EXPECT_FALSE(soundOf(rest, "S3"));
  EXPECT_FALSE(soundOf(rest, "S4"));
  EXPECT_TRUE(soundOf(solve("heart-failure-reduced-ef"), "S3"));
  EXPECT_TRUE(soundOf(solve("heart-failure-preserved-ef"), "S4"));
  EXPECT_TRUE(soundOf(solve("mitral-regurgitation"), "S3"));
  EXPECT_TRUE(soundOf(solve("aortic-stenosis"), "S4"));
}

TEST(CirculationSigns, MurmursAreHeardWhereValvesAreIll) {
  const Solved rest = solve("rest"), stenosis = solve("aortic-stenosis"),
               leak = solve("mitral-regurgitation");
  // Between the sounds: the middle of ejection.
  EXPECT_LT(loudest(rest, 0.18, 0.30), 0.1);
  EXPECT_GT(loudest(stenosis, 0.18, 0.30), 0.3);
  EXPECT_GT(loudest(leak, 0.18, 0.30), 0.3);
}

TEST(CirculationCurves, TableHasAColumnForEverything) {
  const Solved rest = solve("rest");
  const auto curves = curvesOf(rest.parameters, rest.state.beat, rest.indices);
  std::vector<std::string> names;
  for (const NamedCurve& curve : curves) {
    names.push_back(curve.name);
    EXPECT_EQ(curve.values.size(), 1001u) << curve.name;
    EXPECT_TRUE(std::all_of(curve.values.begin(), curve.values.end(), [](double x) {
      return std::isfinite(x);
    })) << curve.name;
  }
  EXPECT_EQ(names.front(), "time_s");
  EXPECT_THAT(names, testing::IsSupersetOf({"lv_mmHg", "rv_mmHg", "la_mmHg", "ra_mmHg", "aorta_mmHg",
                                            "pulmonary_artery_mmHg", "lv_ml", "ra_ml", "aortic_ml_s",
                                            "mitral_open", "pulmonic_open", "ecg_mV", "sound"}));
}

} // namespace viscera::circulation
