#include "viscera/live/sequence_setup.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "self_intersections.h"
#include "sequence_scene.h"
#include "surface_clearance.h"
#include "viscera/core/error.h"
#include "viscera/document/document.h"
#include "viscera/document/open_files.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/heart/heartbeat.h"
#include "viscera/heart/wall_motion.h"

namespace viscera::live {
namespace {

using heart::CavityHeartbeat;
using heart::CavityVolumes;
using sample_organs::Resolution;
using tests::SequenceScene;

constexpr double kRate = 75;

/// The sample heart with its beat, in the pose of one moment.
class BeatingHeart : public SequenceScene {
public:
  explicit BeatingHeart(Resolution resolution)
      : SequenceScene([&](Progress& progress) {
          return setUpSequence(tests::cachedLibrary(), "heartbeat", resolution, progress);
        }) {}

  const CavityHeartbeat& heartbeat() const { return dynamic_cast<const CavityHeartbeat&>(*setup().sequence); }
};

/// The largest distances of the measured volumes from the curves, and the range of the left one, over one
/// beat.
struct Fit {
  double leftOff = 0;
  double rightOff = 0;
  double leftMost = 0;
  double leftLeast = 1e9;
};

Fit fitOverOneBeat(BeatingHeart& heart, double rate, int frames) {
  Fit fit;
  for (int frame = 0; frame < frames; ++frame) {
    const double seconds = (frame + 0.37) / frames * 60 / rate;
    heart.show(seconds, rate);
    const heart::CardiacCycle& cycle = heart.heartbeat().cycle();
    const CavityVolumes wanted = cycle.at(seconds, rate).volumes;
    const double left = heart.volumeMl("lv");
    fit.leftOff = std::max(fit.leftOff, std::abs(left - wanted.leftMl));
    fit.rightOff = std::max(fit.rightOff, std::abs(heart.volumeMl("rv") - wanted.rightMl));
    fit.leftMost = std::max(fit.leftMost, left);
    fit.leftLeast = std::min(fit.leftLeast, left);
  }
  return fit;
}

TEST(HeartbeatSetup, CavitiesHoldWhatTheCurvesSayAtEveryRate) {
  BeatingHeart heart(Resolution::medium);
  for (const double rate : {20.0, 50.0, 75.0, 100.0, 150.0, 220.0}) {
    const Fit fit = fitOverOneBeat(heart, rate, 40);
    const double stroke = 75.5 * heart.heartbeat().cycle().beat(rate).strokePart();
    EXPECT_LT(fit.leftOff, 0.5) << rate;
    EXPECT_LT(fit.rightOff, 1.0) << rate;
    EXPECT_NEAR(fit.leftMost, 55 + stroke, 0.5) << rate;
    EXPECT_NEAR(fit.leftLeast, 55.0, 0.5) << rate;
  }
}

TEST(HeartbeatSetup, WallsMoveAsMeasuredInHealthyAdultsAndTheLeftMuscleKeepsItsVolume) {
  BeatingHeart heart(Resolution::medium);
  Progress progress;
  heart.add(
      sample_organs::sampleSurface(tests::cachedLibrary(), "heart", "lv_wall", Resolution::medium, progress));
  heart.show(0.12, kRate); // Full, before the ventricles contract.
  const double fullMl = heart.volumeMl("lv_wall") - heart.volumeMl("lv");
  double off = 0;
  const heart::HeartFrame& frame = heart.heartbeat().motion().rig().anatomy.frame;
  const auto points = [&heart](const char* surface) { return heart.posed(surface).points; };
  const auto& surfaces = heart.setup().organ.surfaces; // The outer one, left and right cavity.
  const heart::WallGauge gauge(
      frame, {surfaces[1].mesh->points, surfaces[2].mesh->points, surfaces[0].mesh->points});
  std::vector<heart::WallPlaces> beat;
  for (int frameOfBeat = 0; frameOfBeat < 40; ++frameOfBeat) {
    heart.show(frameOfBeat / 40.0 * 60 / kRate, kRate);
    const Points left = points("lv"), right = points("rv"), outer = points("outer");
    beat.push_back(gauge.at({left, right, outer}));
    off = std::max(off, std::abs(heart.volumeMl("lv_wall") - heart.volumeMl("lv") - fullMl) / fullMl);
  }
  RecordProperty("relativeChangeOfTheLeftMuscle", std::to_string(off));
  EXPECT_LT(off, 0.06);
  const heart::WallMotion motion = heart::wallMotion(beat);
  RecordProperty("thickeningPercent", std::to_string(motion.thickeningPercent));
  for (const heart::WallMotionRange& range : heart::wallMotionRanges()) {
    EXPECT_GE(motion.*range.value, range.low) << range.name;
    EXPECT_LE(motion.*range.value, range.high) << range.name;
  }
}

TEST(HeartbeatSetup, isCalibratedOnTheResolutionThatIsShown) {
  // The coarse left cavity holds more than a millilitre less at rest.
  BeatingHeart heart(Resolution::low);
  const Fit fit = fitOverOneBeat(heart, kRate, 60);
  EXPECT_LT(fit.leftOff, 0.5);
  EXPECT_LT(fit.rightOff, 1.0);
}

TEST(HeartbeatSetup, wholeHeartLosesAsMuchVolumeInSystoleAsMeasuredInPeople) {
  BeatingHeart heart(Resolution::medium);
  double most = 0;
  double least = 1e9;
  for (int frame = 0; frame < 48; ++frame) {
    heart.show(frame / 48.0 * 60 / kRate, kRate);
    most = std::max(most, heart.volumeMl("outer"));
    least = std::min(least, heart.volumeMl("outer"));
  }
  const double change = (most - least) / most;
  RecordProperty("outerVolumeChange", std::to_string(change));
  EXPECT_GT(change, 0.048);
  EXPECT_LT(change, 0.106);
}

TEST(HeartbeatSetup, noSurfaceCrossesItselfInAnyFrame) {
  BeatingHeart heart(Resolution::medium);
  for (int frame = 0; frame < 24; ++frame) {
    heart.show(frame / 24.0 * 60 / kRate, kRate);
    for (const char* surface : {"outer", "lv", "rv"})
      EXPECT_EQ(tests::selfIntersections(heart.posed(surface)), 0) << surface << " in frame " << frame;
  }
}

TEST(HeartbeatSetup, cavitiesStayInsideTheWallAndApartInEveryFrame) {
  BeatingHeart heart(Resolution::medium);
  for (int frame = 0; frame < 24; ++frame) {
    heart.show(frame / 24.0 * 60 / kRate, kRate);
    const geometry::TriangleMesh outer = heart.posed("outer");
    const geometry::TriangleMesh left = heart.posed("lv");
    const Points right = heart.posed("rv").points;
    EXPECT_GT(tests::clearanceInsideOf(outer, left.points), 5) << frame;
    EXPECT_GT(tests::clearanceInsideOf(outer, right), 2) << frame;
    EXPECT_GT(tests::clearanceOutsideOf(left, right), 5) << frame;
  }
}

TEST(HeartbeatSetup, trianglesKeepTheirShapeInEveryFrame) {
  BeatingHeart heart(Resolution::medium);
  double worstOuter = 1;
  double worstCavity = 1;
  for (int frame = 0; frame < 48; ++frame) {
    heart.show(frame / 48.0 * 60 / kRate, kRate);
    worstOuter = std::min(worstOuter, heart.worstTriangle("outer"));
    worstCavity = std::min({worstCavity, heart.worstTriangle("lv"), heart.worstTriangle("rv")});
  }
  RecordProperty("worstTriangleOfTheOuterSurface", std::to_string(worstOuter));
  RecordProperty("worstTriangleOfTheCavities", std::to_string(worstCavity));
  EXPECT_GT(worstOuter, 0.35);
  // 0.63 is measured. It was 0.7 while the right ventricle kept 66 ml, and the left one had a wall of 10.5 mm
  // to average over; now both eject the same (62.5 ml are kept) and the wall weighs what a healthy one does.
  EXPECT_GT(worstCavity, 0.6);
}

TEST(HeartbeatSetup, handlesComeLabelledInTheGroupsOfTheirRoles) {
  BeatingHeart heart(Resolution::low);
  const document::Rig& rig = heart.setup().rig;
  ASSERT_EQ(static_cast<Eigen::Index>(rig.handles.size()), heart.setup().sequence->restHandles().rows());
  std::set<std::string> labels;
  std::size_t grouped = 0;
  for (const document::Handle& handle : rig.handles)
    labels.insert(handle.label);
  for (const document::Group& group : rig.groups)
    grouped += group.handles.size();
  EXPECT_EQ(labels.size(), rig.handles.size());
  EXPECT_EQ(grouped, rig.handles.size());
  EXPECT_TRUE(labels.contains("LV endocardium 1"));
  EXPECT_TRUE(labels.contains("Far corners 8"));
}

TEST(HeartbeatSetup, fitsTheDocument) {
  BeatingHeart heart(Resolution::low);
  document::Document document;
  document::UndoStack undo(document);
  undo.perform(document::combined("Show", {document::addOrgans(document::organsFrom(heart.setup().organ)),
                                           document::replaceRig(heart.setup().rig),
                                           document::setSystem(heart.setup().system)}));
  EXPECT_EQ(document.organs().size(), 5u);
  EXPECT_EQ(document.rig().restPositions(), heart.setup().sequence->restHandles());
  EXPECT_EQ(document.system().parameters.all(), heart.setup().system.parameters.all());
  undo.undo();
  EXPECT_TRUE(document.organs().empty());
  EXPECT_TRUE(document.rig().handles.empty());
}

TEST(HeartbeatSetup, worksWithoutAnyCache) {
  Progress progress;
  const SequenceSetup setup =
      setUpSequence({tests::cachedLibrary().definitions, {}}, "heartbeat", Resolution::low, progress);
  EXPECT_EQ(setup.sequence->id(), "heartbeat");
}

TEST(HeartbeatSetup, canBeCancelledAtAnyPoint) {
  for (const double limit : {0.0, 0.3, 0.85}) {
    Progress* running = nullptr;
    Progress progress([&](double fraction, const Text&) {
      if (fraction >= limit)
        running->cancel();
    });
    running = &progress;
    EXPECT_THROW(
        setUpSequence({tests::cachedLibrary().definitions, {}}, "heartbeat", Resolution::low, progress),
        Cancelled)
        << limit;
  }
}

TEST(SequenceSetup, namesTheSequencesThereAreWhenAskedForAnother) {
  Progress progress;
  try {
    setUpSequence(tests::cachedLibrary(), "hiccup", Resolution::low, progress);
    FAIL() << "there is no hiccup";
  } catch (const UsageError& error) {
    EXPECT_NE(error.tryThis().english().find("heartbeat"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace viscera::live
