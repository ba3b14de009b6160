#include "viscera/live/circulating_heart.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "self_intersections.h"
#include "sequence_scene.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/heart/cardiac_times.h"
#include "viscera/heart/wall_motion.h"

namespace viscera::live {
namespace {

using sample_organs::Resolution;
using tests::SequenceScene;

constexpr int kFrames = 40;
constexpr int kChecked = 5; ///< Every so manieth frame is checked for self-intersection.

/// The sample heart in a scenario, in the pose of one moment.
class ScenarioHeart : public SequenceScene {
public:
  explicit ScenarioHeart(const std::string& scenario)
      : SequenceScene([&](Progress& progress) {
          return circulatingHeart(tests::cachedLibrary(), circulation::scenario(scenario).name,
                                  circulation::scenarioParameters(scenario), Resolution::low, progress);
        }) {}

  const heart::CourseHeartbeat& heartbeat() const {
    return dynamic_cast<const heart::CourseHeartbeat&>(*setup().sequence);
  }
};

/// What is seen of a scenario's left ventricle at the end of diastole.
struct LeftVentricle {
  double muscleMl = 0;
  double wallMm = 0;
};

LeftVentricle leftVentricleOf(const std::string& scenario) {
  ScenarioHeart heart(scenario);
  Progress progress;
  heart.add(
      sample_organs::sampleSurface(tests::cachedLibrary(), "heart", "lv_wall", Resolution::low, progress));
  heart.show(0, heart.setup().sequence->standardRatePerMinute());
  const auto& surfaces = heart.setup().organ.surfaces; // The outer one, left and right cavity.
  const Points left = heart.posed("lv").points, right = heart.posed("rv").points,
               outer = heart.posed("outer").points;
  const heart::WallGauge gauge(
      heart.heartbeat().motion().rig().anatomy.frame,
      {surfaces[1].mesh->points, surfaces[2].mesh->points, surfaces[0].mesh->points});
  return {heart.volumeMl("lv_wall") - heart.volumeMl("lv"), gauge.at({left, right, outer}).wallMm};
}

} // namespace

TEST(CirculatingHeart, HypertrophiedAndDilatedHeartsAreDrawnWithTheirMuscle) {
  const LeftVentricle rest = leftVentricleOf("rest");
  EXPECT_NEAR(rest.muscleMl, 111.7, 0.06 * 111.7);
  for (const std::string id : {"hypertension", "aortic-stenosis", "heart-failure-reduced-ef"}) {
    const LeftVentricle ill = leftVentricleOf(id);
    const double wanted = circulation::scenario(id).leftMuscle;
    RecordProperty(id + "Muscle", std::to_string(ill.muscleMl / rest.muscleMl));
    RecordProperty(id + "WallMm", std::to_string(ill.wallMm));
    EXPECT_NEAR(ill.muscleMl / rest.muscleMl, wanted, 0.1) << id;
    // Dilated, more muscle lies around a larger cavity: the wall is as thick as that of a healthy heart.
    if (id == "heart-failure-reduced-ef") {
      EXPECT_NEAR(ill.wallMm, rest.wallMm, 1) << id;
    } else {
      EXPECT_GT(ill.wallMm, 1.15 * rest.wallMm) << id;
    }
  }
}

TEST(CirculatingHeart, ABeatTakenFromAnotherOneHoldsItsOwnVolumes) {
  ScenarioHeart resting("rest");
  // A control that moved a little, one that jumped, and another scenario altogether.
  circulation::Parameters little, much;
  circulation::setParameter(little, "stressedVolume", 1000);
  circulation::setParameter(much, "stressedVolume", 700);
  Progress progress;
  for (const auto& parameters : {little, much, circulation::scenarioParameters("exercise")}) {
    const circulation::Beat beat = circulation::findPeriodicState(parameters, progress).beat;
    const heart::HeartCourse course =
        heartCourse("Taken", parameters, beat, circulation::indicesOf(parameters, beat));
    const heart::CourseHeartbeat taken(resting.heartbeat(), course);
    EXPECT_EQ(taken.name().english(), "Taken");
    EXPECT_NEAR(taken.standardRatePerMinute(), parameters.rate, 1e-9);
    for (const double phase : {0.02, 0.21, 0.38, 0.55, 0.83}) {
      resting.show(taken, phase * beat.period, parameters.rate);
      EXPECT_NEAR(resting.volumeMl("lv"), course.at(phase).volumes.leftMl, 0.5) << phase;
      EXPECT_NEAR(resting.volumeMl("rv"), course.at(phase).volumes.rightMl, 1) << phase;
    }
  }
}

TEST(CirculatingHeart, CavitiesHoldTheCirculationsVolumesInEveryScenarioWithoutCrossingThemselves) {
  for (const circulation::Scenario& scenario : circulation::scenarios()) {
    ScenarioHeart heart(scenario.id);
    const double rate = heart.heartbeat().standardRatePerMinute();
    Progress progress;
    heart.add(
        sample_organs::sampleSurface(tests::cachedLibrary(), "heart", "chambers", Resolution::low, progress));
    double leftOff = 0, rightOff = 0, atriaOff = 0, leastWall = 1e9, mostWall = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      // Not at the phases where it was calibrated.
      const double phase = (frame + 0.37) / kFrames;
      heart.show(phase * 60 / rate, rate);
      const heart::CavityVolumes wanted = heart.heartbeat().heartCourse().at(phase).volumes;
      leftOff = std::max(leftOff, std::abs(heart.volumeMl("lv") - wanted.leftMl));
      rightOff = std::max(rightOff, std::abs(heart.volumeMl("rv") - wanted.rightMl));
      const heart::CavityVolumes atria = heart.heartbeat().heartCourse().at(phase).atria.value();
      atriaOff = std::max({atriaOff, std::abs(heart.volumeMl("la") - atria.leftMl),
                           std::abs(heart.volumeMl("ra") - atria.rightMl)});
      const double wall = heart.volumeMl("chambers") - heart.volumeMl("lv") - heart.volumeMl("rv") -
                          heart.volumeMl("la") - heart.volumeMl("ra");
      leastWall = std::min(leastWall, wall);
      mostWall = std::max(mostWall, wall);
      if (frame % kChecked != 0)
        continue;
      for (const char* surface : {"outer", "lv", "rv", "la", "ra"})
        EXPECT_EQ(tests::selfIntersections(heart.posed(surface)), 0)
            << scenario.id << ", " << surface << " in frame " << frame;
    }
    EXPECT_LT(leftOff, 0.5) << scenario.id;
    EXPECT_LT(rightOff, 1.0) << scenario.id;
    EXPECT_LT(atriaOff, 1.0) << scenario.id;
    // Either way from its middle.
    const double wallChange = (mostWall - leastWall) / (mostWall + leastWall);
    RecordProperty(scenario.id + "WallChange", std::to_string(wallChange));
    EXPECT_LT(wallChange, 0.05) << scenario.id;
  }
}

TEST(CirculatingHeart, AtriaFillWhileTheVentriclesEmptyAndHoldWhatTheCirculationSays) {
  const circulation::Parameters parameters;
  Progress progress;
  const circulation::PeriodicState found = circulation::findPeriodicState(parameters, progress);
  const heart::HeartCourse course =
      heartCourse("rest", parameters, found.beat, circulation::indicesOf(parameters, found.beat));
  const auto& left = found.beat.volumeOf(circulation::Compartment::la);
  const auto& right = found.beat.volumeOf(circulation::Compartment::ra);
  const auto& instants = course.instants;
  const std::size_t first = circulation::firstDrawn(parameters, found.beat, heart::kBeforeAtria);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const std::size_t sample = (first + i) % instants.size();
    EXPECT_NEAR(instants[i].atria->leftMl, left[sample], 1e-9);
    EXPECT_NEAR(instants[i].atria->rightMl, right[sample], 1e-9);
  }
  const auto emptiest = std::min_element(instants.begin(), instants.end(), [](const auto& a, const auto& b) {
    return a.volumes.leftMl < b.volumes.leftMl;
  });
  const auto& contracted = instants[instants.size() - first]; // The ventricles begin to contract.
  EXPECT_GT(emptiest->atria->leftMl, 1.5 * contracted.atria->leftMl);
  EXPECT_GT(emptiest->atria->rightMl, 1.5 * contracted.atria->rightMl);
}

TEST(CirculatingHeart, HasTheRateAndThePhasesOfItsCirculation) {
  const ScenarioHeart heart("exercise");
  const sequences::Sequence& sequence = *heart.setup().sequence;
  EXPECT_NEAR(sequence.standardRatePerMinute(), 150, 1e-9);
  EXPECT_EQ(sequence.lowestRatePerMinute(), sequence.highestRatePerMinute());
  const auto phases = sequence.phases(150);
  EXPECT_EQ(phases.front().begin, 0);
  EXPECT_EQ(phases.back().end, 1);
  for (std::size_t i = 1; i < phases.size(); ++i)
    EXPECT_EQ(phases[i].begin, phases[i - 1].end);
  const auto ejection = [&](const char* name) {
    return *std::find_if(phases.begin(), phases.end(), [&](const auto& phase) { return phase.name == name; });
  };
  // The left ventricle empties in this phase and in no other.
  const auto volumeAt = [&](double phase) {
    return heart.heartbeat().heartCourse().at(phase).volumes.leftMl;
  };
  EXPECT_GT(volumeAt(ejection("rapid ejection").begin) - volumeAt(ejection("reduced ejection").end), 80);
}

TEST(CirculatingHeart, RefusesACirculationThatNeverRepeatsItself) {
  circulation::Parameters parameters;
  circulation::setParameter(parameters, "pericardialFluid", 600);
  Progress progress;
  EXPECT_THROW(circulatingHeart(tests::cachedLibrary(), "Full", parameters, Resolution::low, progress),
               DataError);
}

} // namespace viscera::live
