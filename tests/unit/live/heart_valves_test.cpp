#include "viscera/heart/heart_valves.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sequence_scene.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/heart/valve_leaflets.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/motion_recipe.h"

namespace viscera::live {
namespace {

using heart::HeartValve;
using heart::ValveInstants;
using heart::ValveRing;

heart::HeartCourse courseOf(const circulation::Parameters& parameters) {
  Progress quiet;
  const circulation::PeriodicState found = circulation::findPeriodicState(parameters, quiet);
  return heartCourse("a beat", parameters, found.beat, circulation::indicesOf(parameters, found.beat));
}

const heart::ValveInstant& of(const ValveInstants& valves, HeartValve valve) {
  return valves[static_cast<std::size_t>(valve)];
}

double widestMm2(const heart::HeartCourse& course, HeartValve valve) {
  double widest = 0;
  for (const ValveInstants& valves : course.valves)
    widest = std::max(widest, of(valves, valve).areaMm2);
  return widest;
}

/// The parts of a beat from the contraction of the atria; the last one goes on in the first.
std::vector<sequences::Phase> fromAtria(std::vector<sequences::Phase> phases) {
  phases.front().begin = phases.back().begin;
  phases.pop_back();
  std::rotate(phases.begin(),
              std::find_if(phases.begin(), phases.end(),
                           [](const sequences::Phase& phase) { return phase.name == "atrial systole"; }),
              phases.end());
  return phases;
}

} // namespace

TEST(HeartValves, OpenAsTheCirculationSaysAndCarryWhatTheVentriclesGainAndLose) {
  const heart::HeartCourse course = courseOf(circulation::scenarioParameters("rest"));
  ASSERT_EQ(course.valves.size(), course.instants.size());
  EXPECT_NEAR(widestMm2(course, HeartValve::mitral), 500, 10);
  EXPECT_NEAR(widestMm2(course, HeartValve::aortic), 400, 10);
  const auto count = course.instants.size();
  const double step = course.period / static_cast<double>(count);
  for (std::size_t i = 1; i + 1 < count; i += 17) {
    const ValveInstants& now = course.valves[i];
    const double gains =
        (course.instants[i + 1].volumes.leftMl - course.instants[i - 1].volumes.leftMl) / (2 * step);
    EXPECT_NEAR(of(now, HeartValve::mitral).flowMlPerS - of(now, HeartValve::aortic).flowMlPerS, gains, 8);
  }
}

/// The moving leaflets, the timeline's phases and the numbers of the circulation say the same.
TEST(HeartValves, AreOpenWhereThePhasesAndTheNumbersSaySo) {
  for (const circulation::Scenario& scenario : circulation::scenarios()) {
    const circulation::Parameters parameters = circulation::scenarioParameters(scenario.id);
    Progress quiet;
    const circulation::PeriodicState found = circulation::findPeriodicState(parameters, quiet);
    const circulation::Indices indices = circulation::indicesOf(parameters, found.beat);
    const heart::HeartCourse course = heartCourse("a beat", parameters, found.beat, indices);
    double ejection = 0, contraction = 0, end = 0;
    for (const sequences::Phase& phase : course.phases) {
      EXPECT_EQ(phase.begin, end) << scenario.id;
      end = phase.end;
      const std::string& name = phase.name.english();
      const bool ejects = name.find("ejection") != std::string::npos;
      ejection += ejects ? phase.end - phase.begin : 0;
      contraction += name == "isovolumic contraction" ? phase.end - phase.begin : 0;
      const double middle = (phase.begin + phase.end) / 2;
      const double aorticMm2 = of(*course.valvesAt(middle), HeartValve::aortic).areaMm2;
      EXPECT_EQ(aorticMm2 > 0, ejects) << scenario.id << ", " << name;
      if (name.rfind("isovolumic", 0) == 0) {
        EXPECT_NEAR(of(*course.valvesAt(middle), HeartValve::mitral).areaMm2, 100 * parameters.mitral.leak,
                    1e-6)
            << scenario.id << ", " << name;
      }
    }
    EXPECT_EQ(end, 1) << scenario.id;
    EXPECT_NEAR(ejection * course.period, indices.ejectionSeconds, 1e-9) << scenario.id;
    EXPECT_NEAR(contraction * course.period, indices.isovolumicContractionSeconds, 1e-9) << scenario.id;
  }
}

/// The textbook's beat and that of a circulation begin alike.
TEST(HeartValves, OfACirculationMoveInPhasesWithTheNamesOfTheTextbook) {
  const heart::HeartCourse course = courseOf(circulation::scenarioParameters("rest"));
  const auto found = fromAtria(course.phases), textbook = fromAtria(heart::CardiacCycle::phases(72));
  ASSERT_EQ(found.size(), textbook.size());
  for (std::size_t i = 0; i < textbook.size(); ++i) {
    EXPECT_EQ(found[i].name.english(), textbook[i].name.english());
    EXPECT_EQ(found[i].group, textbook[i].group);
    EXPECT_LT(std::abs(std::remainder(found[i].begin - textbook[i].begin, 1.0)), 0.12)
        << textbook[i].name.english();
  }
}

TEST(HeartValves, NarrowOnesOpenLessAndLeakingOnesKeepAGapThroughWhichBloodFlowsBack) {
  EXPECT_NEAR(widestMm2(courseOf(circulation::scenarioParameters("aortic-stenosis")), HeartValve::aortic), 80,
              5);
  const circulation::Parameters leaking = circulation::scenarioParameters("mitral-regurgitation");
  double fastestBack = 0;
  for (const ValveInstants& valves : courseOf(leaking).valves) {
    EXPECT_GE(of(valves, HeartValve::mitral).areaMm2, 100 * leaking.mitral.leak - 1e-6);
    fastestBack = std::min(fastestBack, of(valves, HeartValve::mitral).flowMlPerS);
  }
  EXPECT_LT(fastestBack, -100);
}

TEST(HeartValves, OfTheTextbooksBeatMoveWithItsPhases) {
  const heart::CardiacBeat beat = heart::CardiacCycle().beat(75);
  const auto at = [&beat](double seconds) { return heart::textbookValves(beat, seconds); };
  const auto between = [](double a, double b) { return (a + b) / 2; };
  const double ejection = between(beat.left().outletOpens, beat.left().outletShuts);
  EXPECT_NEAR(of(at(ejection), HeartValve::aortic).areaMm2, 400, 1e-9);
  EXPECT_GT(of(at(ejection), HeartValve::aortic).flowMlPerS, 100);
  EXPECT_EQ(of(at(ejection), HeartValve::mitral).areaMm2, 0);
  const double relaxation = between(beat.left().outletShuts, beat.left().inletOpens);
  EXPECT_EQ(of(at(relaxation), HeartValve::aortic).areaMm2, 0);
  EXPECT_EQ(of(at(relaxation), HeartValve::mitral).areaMm2, 0);
  const double filling = beat.left().inletOpens + 0.09;
  EXPECT_NEAR(of(at(filling), HeartValve::mitral).areaMm2, 500, 1e-9);
  EXPECT_GT(of(at(filling), HeartValve::mitral).flowMlPerS, 100);
  for (double seconds = 0; seconds < 0.8; seconds += 0.005) // No faster than blood is.
    for (const heart::ValveInstant& valve : at(seconds))
      if (valve.flowMlPerS > 0) {
        EXPECT_LT(valve.flowMlPerS * 1000 / valve.areaMm2, 1500) << seconds;
      }
}

TEST(HeartValves, OfASessionAreThoseOfItsMotion) {
  const MotionRecipe heart = SampleMotion{"heartbeat", sample_organs::Resolution::low};
  document::CirculationChoice choice;
  Progress quiet;
  EXPECT_EQ(heartValves(heart, choice, 0.4, 75, quiet),
            heart::textbookValves(heart::CardiacCycle().beat(75), 0.4 * 60 / 75));
  choice.drives = true;
  EXPECT_EQ(heartValves(heart, choice, 0.2, 72, quiet), courseOf(choice.parameters).valvesAt(0.2));
  EXPECT_EQ(heartValves(SampleMotion{"breathing", sample_organs::Resolution::low}, choice, 0.2, 72, quiet),
            std::nullopt);
}

TEST(HeartClock, OfASessionCountsFromTheContractionOfItsVentricles) {
  const MotionRecipe heart = SampleMotion{"heartbeat", sample_organs::Resolution::low};
  document::CirculationChoice choice;
  Progress quiet;
  EXPECT_EQ(heartClock(heart, choice, 0.4, 75, quiet),
            heart::clockOf(heart::CardiacCycle().beat(75), 0.4 * 60 / 75));
  choice.drives = true;
  const auto clock = heartClock(heart, choice, 0, 72, quiet);
  ASSERT_TRUE(clock);
  const double cycle = 60 / choice.parameters.rate;
  EXPECT_NEAR(clock->seconds, cycle - clock->conduction - heart::kBeforeAtria, 0.01)
      << "the drawn beat begins before the atria contract";
  EXPECT_EQ(clock->conduction, choice.parameters.conduction);
  EXPECT_EQ(heartClock(SampleMotion{"breathing", sample_organs::Resolution::low}, choice, 0.2, 72, quiet),
            std::nullopt);
}

TEST(HeartValves, LieBetweenTheChambersAndVesselsOfTheSampleHeart) {
  const auto node = [](const char* name) {
    return sample_organs::implicitSurface(tests::cachedLibrary(), "heart", name);
  };
  const auto left = node("surf lv"), right = node("surf rv"), aorta = node("aorta"),
             trunk = node("pulmonary");
  const heart::ValveRings rings = heart::sampleHeartRings();
  const auto along = [](const ValveRing& ring, double mm) -> Vec3 {
    return ring.center + mm * ring.downstream;
  };
  EXPECT_LT(left(along(rings[0], 6)), 0);
  EXPECT_GT(left(along(rings[0], -4)), 0);
  EXPECT_LT(left(along(rings[1], -9)), 0);
  EXPECT_LT(aorta(along(rings[1], 8)), 0);
  EXPECT_LT(right(along(rings[2], 6)), 0);
  EXPECT_GT(right(along(rings[2], -4)), 0);
  EXPECT_LT(right(along(rings[3], -8)), 0);
  EXPECT_LT(trunk(along(rings[3], 8)), 0);
  for (const ValveRing& ring : rings) { // Orthogonal, and their orifices in health fit.
    EXPECT_NEAR(ring.first.dot(ring.second), 0, 1e-9);
    EXPECT_NEAR(ring.first.cross(ring.second).normalized().dot(ring.downstream), 1, 1e-9);
  }
  EXPECT_GT(rings[0].areaMm2(), 500);
  EXPECT_GT(rings[1].areaMm2(), 400);
  EXPECT_GT(rings[2].areaMm2(), 600);
  EXPECT_GT(rings[3].areaMm2(), 400);
}

TEST(HeartValves, RingsDescendWithTheValvePlane) {
  tests::SequenceScene heart([](Progress& progress) {
    return setUpSequence(tests::cachedLibrary(), "heartbeat", sample_organs::Resolution::low, progress);
  });
  const heart::ValveRings rings = heart::sampleHeartRings();
  const auto& surfaces = heart.setup().organ.surfaces;
  const auto left =
      std::find_if(surfaces.begin(), surfaces.end(), [](const auto& one) { return one.name == "lv"; });
  const heart::CarriedRing mitral(rings[0], left->mesh->points);
  const heart::CardiacBeat beat = heart::CardiacCycle().beat(75);
  heart.show(beat.left().inletShuts, 75);
  const ValveRing before = mitral.at(heart.posed("lv").points);
  heart.show(beat.left().outletShuts, 75);
  const ValveRing after = mitral.at(heart.posed("lv").points);
  const double descends = (after.center - before.center).dot(before.downstream);
  EXPECT_GT(descends, 8); // MAPSE: 12 to 15 mm at the wall.
  EXPECT_LT(descends, 18);
  EXPECT_GT(after.downstream.dot(before.downstream), 0.95);
}

} // namespace viscera::live
