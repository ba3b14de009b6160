#include "viscera/live/volume_keeper.h"

#include <atomic>
#include <future>
#include <limits>
#include <optional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "counting_system.h"
#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::live {
namespace {

using ::testing::HasSubstr;
using tests::ball;

constexpr double kAllowedVolumeError = 1e-9;

/// A document with a ball, kept bound at once, and a keeper of its locked volumes.
struct Keeping : tests::Session {
  coordinates::Registry registry = coordinates::builtInRegistry();
  JobQueue jobs{[](std::function<void()> work) { work(); }};
  LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {2}}};
  VolumeKeeper keeper{document.state(), live};

  double relativeChange(std::size_t place = 0) { return live.volume(organ(place)).relativeChange(); }
  void take(const LockedMotion& motion) { undo.perform(document::setPose(motion.pose())); }
};

/// The same ball without some of its triangles.
document::NewOrgan openBall(const std::string& name) {
  geometry::TriangleMesh mesh = viscera::tests::sphere(3, 30);
  mesh.triangles.conservativeResize(mesh.triangles.rows() - 7, 3);
  return {document::makeOrgan(name, mesh), -1};
}

TEST(VolumeKeeper, AMotionUnderWayKeepsItsVolumeWhenAnotherOneIsAskedFor) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  LockedMotion motion = s.keeper.begin({s.handle(9)});
  s.keeper.poseOfVolume(s.organ(), 0.9 * s.document.organs().front()->restVolumeMm3);
  motion.translate({6, 4, -3});
  s.take(motion);
  EXPECT_LE(std::abs(s.relativeChange()), kAllowedVolumeError);
}

TEST(VolumeKeeper, AMotionOfALockedOrganKeepsItsVolumeAndUndoUnlocksAgain) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  LockedMotion motion = s.keeper.begin({s.handle(9)});
  motion.translate({6, 4, -3});
  s.take(motion);
  EXPECT_LE(std::abs(s.relativeChange()), kAllowedVolumeError);
  EXPECT_GT((s.live.points(s.organ()) - s.document.organs().front()->mesh->points).norm(), 0.1);
  s.undo.undo();
  s.undo.undo();
  EXPECT_FALSE(s.document.organs().front()->volumeLocked);
  motion = s.keeper.begin({s.handle(9)});
  motion.translate({6, 4, -3});
  s.take(motion);
  EXPECT_GT(std::abs(s.relativeChange()), 1e-3);
}

TEST(VolumeKeeper, TheVolumeThatIsKeptIsTheOneThatTheOrganHas) {
  Keeping s;
  s.undo.perform(document::moveHandles({s.handle(9)}, tests::row(60, 3, -1)));
  const double before = s.relativeChange();
  ASSERT_GT(std::abs(before), 1e-3);
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  LockedMotion motion = s.keeper.begin({s.handle(8), s.handle(1)});
  motion.translate({6, 4, -3});
  s.take(motion);
  EXPECT_NEAR(s.relativeChange(), before, kAllowedVolumeError);
}

TEST(VolumeKeeper, ALongWalkDoesNotDrift) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  for (int i = 0; i < 200; ++i) {
    LockedMotion motion = s.keeper.begin({s.handle(static_cast<std::size_t>(i % 10))});
    motion.translate({std::sin(i), std::cos(3 * i), std::sin(2 * i)});
    s.take(motion);
  }
  EXPECT_LE(std::abs(s.relativeChange()), kAllowedVolumeError);
}

TEST(VolumeKeeper, SeveralLockedOrgansOnTheSameHandlesAllKeepTheirVolumes) {
  Keeping s;
  s.undo.perform(document::addOrgans({ball("Second", 9, 2, {12, 0, 0}), ball("Third", 7, 2, {-10, 5, 8})}));
  for (const std::size_t place : {0, 1, 2})
    s.undo.perform(document::setVolumeLocked(s.organ(place), true));
  LockedMotion motion = s.keeper.begin({s.handle(9)});
  motion.translate({5, 1, 2});
  EXPECT_EQ(motion.obstacle().english(), "");
  s.take(motion);
  for (const std::size_t place : {0, 1, 2})
    EXPECT_LE(std::abs(s.relativeChange(place)), kAllowedVolumeError) << place;
}

TEST(VolumeKeeper, MarkedHandlesCompensateAndLockedOnesNeverMove) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  document::HandleEdit mark;
  mark.compensates = true;
  s.undo.perform(document::editHandles({s.handle(8), s.handle(0)}, mark));
  document::HandleEdit fix;
  fix.locked = true;
  s.undo.perform(document::editHandles({s.handle(0)}, fix));
  LockedMotion motion = s.keeper.begin({s.handle(9), s.handle(0)});
  EXPECT_EQ(motion.selection(), std::vector<int>{9}) << "a locked handle is not a part of the motion";
  const Points& pose = motion.translate({5, 0, 0});
  EXPECT_EQ(pose.row(9), motion.start().row(9) + Eigen::RowVector3d(5, 0, 0));
  EXPECT_NE(pose.row(8), motion.start().row(8));
  EXPECT_EQ(pose.topRows(8), motion.start().topRows(8));
}

TEST(VolumeKeeper, AHandleThatIsMovedExactlyGoesAllTheWayAndFreeOnesCompensate) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  const Points rest = s.document.pose();
  const Vec3 by(9, 8, -6);
  LockedMotion bent = s.keeper.begin({s.handle(9)});
  bent.translate(by);
  ASSERT_EQ(bent.asked(), by);
  EXPECT_GT((bent.given() - by).norm(), 1) << "the plane of the lock leaves less";
  EXPECT_LE(bent.given().norm(), by.norm());
  LockedMotion motion = s.keeper.begin({s.handle(9)}, std::nullopt, std::nullopt, Others::compensate);
  motion.translate(by);
  EXPECT_TRUE(motion.obstacle().empty()) << motion.obstacle().english();
  s.take(motion);
  const Points moved = s.document.pose() - rest;
  EXPECT_LE((moved.row(9).transpose() - by).norm(), 1e-12);
  EXPECT_LE((motion.given() - by).norm(), 1e-12);
  EXPECT_GT((moved.rowwise().norm().array() > 1e-6).count(), 1);
  EXPECT_LE(std::abs(s.relativeChange()), kAllowedVolumeError);
  motion.rotate(Vec3::Zero(), Vec3::UnitX(), 0.1);
  EXPECT_FALSE(motion.asked()) << "a turn is no vector";
}

TEST(VolumeKeeper, FreeHandlesFollowADragAndLockedOnesHoldTheOrgan) {
  Keeping s;
  s.keeper.setSystems(s.registry);
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  document::HandleEdit hold;
  hold.locked = true;
  s.undo.perform(document::editHandles({s.handle(0), s.handle(1), s.handle(2)}, hold));
  const Points rest = s.document.pose();
  const Vec3 by(9, 8, -6);
  LockedMotion motion = s.keeper.begin({s.handle(9)}, std::nullopt, std::nullopt, Others::follow);
  motion.translate(by);
  EXPECT_TRUE(motion.obstacle().empty()) << motion.obstacle().english();
  const Points moved = motion.pose() - rest;
  EXPECT_LE((moved.row(9).transpose() - by).norm(), 1e-12) << "it goes all the way";
  EXPECT_EQ(moved.topRows(3), Points::Zero(3, 3));
  EXPECT_GT(moved.row(8).norm(), 0.05);
  s.take(motion);
  EXPECT_LE(std::abs(s.relativeChange()), kAllowedVolumeError);
  motion.translate(Vec3::Zero());
  EXPECT_EQ(motion.pose(), motion.start()) << "a drag that returns to its start";
}

TEST(VolumeKeeper, HandlesOfAnOrganThatDoesNotBendHaveNothingToFollow) {
  Keeping s;
  EXPECT_THROW(s.keeper.begin({s.handle(9)}, std::nullopt, std::nullopt, Others::follow), UsageError)
      << "without systems";
  s.keeper.setSystems(s.registry);
  s.undo.perform(document::setMobility({s.organ()}, document::Mobility::fixed));
  EXPECT_THROW(s.keeper.begin({s.handle(9)}, std::nullopt, std::nullopt, Others::follow), DataError);
}

TEST(VolumeKeeper, AMoveThatNoOtherHandleCanCompensateSaysSo) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  document::HandleEdit lock;
  lock.locked = true;
  for (std::size_t row = 0; row < s.document.rig().handles.size(); ++row)
    if (row != 9)
      s.undo.perform(document::editHandles({s.handle(row)}, lock));
  LockedMotion motion = s.keeper.begin({s.handle(9)}, std::nullopt, std::nullopt, Others::compensate);
  motion.translate({9, 8, -6});
  EXPECT_FALSE(motion.obstacle().empty());
  EXPECT_EQ(motion.pose(), motion.start());
}

TEST(VolumeKeeper, AMirroredPairMovesMirroredAndKeepsTheVolume) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  const deformation::MirrorPlane sagittal;
  EXPECT_EQ(s.keeper.partners({s.handle(2)}, sagittal), std::vector<int>{3});
  LockedMotion motion = s.keeper.begin({s.handle(2)}, sagittal);
  const Points& pose = motion.translate({-7, 2, 5});
  const Vec3 one = (pose.row(2) - motion.start().row(2)).transpose();
  const Vec3 other = (pose.row(3) - motion.start().row(3)).transpose();
  EXPECT_NEAR((sagittal.reflectedDirection(one) - other).norm(), 0, 1e-12);
  EXPECT_GT(one.norm(), 1);
  s.take(motion);
  EXPECT_LE(std::abs(s.relativeChange()), kAllowedVolumeError);
}

TEST(VolumeKeeper, ATargetVolumeIsMetAndAnotherLockedOrganKeepsItsOwn) {
  Keeping s;
  s.undo.perform(document::addOrgans({ball("Second", 9, 2, {12, 0, 0})}));
  s.undo.perform(document::setVolumeLocked(s.organ(1), true));
  const double target = 0.93 * s.document.organs().front()->restVolumeMm3;
  s.undo.perform(document::setPose(s.keeper.poseOfVolume(s.organ(), target)));
  EXPECT_NEAR(s.relativeChange(0), -0.07, kAllowedVolumeError);
  EXPECT_LE(std::abs(s.relativeChange(1)), kAllowedVolumeError);
}

TEST(VolumeKeeper, ATargetOutOfReachIsRefusedInWords) {
  Keeping s;
  const document::DocumentState before = s.document.state();
  try {
    s.keeper.poseOfVolume(s.organ(), 40 * s.document.organs().front()->restVolumeMm3);
    FAIL() << "an organ cannot grow forty times";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("mm"));
    EXPECT_FALSE(error.tryThis().empty());
  }
  EXPECT_THROW(s.keeper.poseOfVolume(s.organ(), -1), DataError);
  EXPECT_EQ(s.document.state(), before);
}

TEST(VolumeKeeper, AnOrganWithoutHandlesHoldsNobodyUp) {
  Keeping s;
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  s.undo.perform(document::replaceRig(document::rigAt(tests::row(1, 2, 3))));
  LockedMotion motion = s.keeper.begin({s.handle(0)});
  EXPECT_EQ(motion.translate({1, 0, 0}).row(0), Eigen::RowVector3d(2, 2, 3));
  EXPECT_THROW(s.keeper.poseOfVolume(s.organ(), 100), DataError);
}

TEST(VolumeLockCommand, AnOpenSurfaceIsRefusedWithItsOpenEdgesAndCanBeClosed) {
  Keeping s;
  s.undo.perform(document::addOrgans({openBall("Cup")}));
  const document::OrganId cup = s.organ(1);
  const int edges = s.document.organ(cup)->boundaryEdges;
  ASSERT_GT(edges, 0);
  try {
    s.undo.perform(document::setVolumeLocked(cup, true));
    FAIL() << "an open surface was locked";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr(std::to_string(edges) + " boundary edges"));
  }
  s.undo.perform(document::combined("Close and lock",
                                    {document::closeHoles(cup), document::setVolumeLocked(cup, true)}));
  const auto closed = s.document.organ(cup);
  EXPECT_TRUE(closed->closed());
  EXPECT_TRUE(closed->volumeLocked);
  EXPECT_EQ(closed->name, "Cup");
  EXPECT_GT(closed->restVolumeMm3, 0.9 * s.document.organs().front()->restVolumeMm3);
  for (const Text& warning : closed->warnings)
    EXPECT_EQ(warning.english().find("boundary"), std::string::npos) << warning;
  EXPECT_EQ(s.live.status(cup).state, BindingStatus::State::bound);
  s.undo.undo();
  EXPECT_EQ(s.document.organ(cup)->boundaryEdges, edges);
}

/// The same by coordinates that are counted, with the job queue for the volume forms. Whoever makes one on
/// another thread than the test's waits until `go` is called.
struct Preparing : tests::Session {
  std::shared_ptr<viscera::tests::BindingCounts> counts = std::make_shared<viscera::tests::BindingCounts>();
  std::atomic<int> madeHere{0}; ///< Columns that the test's thread has asked for.
  std::promise<void> gate;
  coordinates::Registry registry = coordinates::builtInRegistry();
  ManualEventLoop box;
  JobQueue jobs{box.post()};
  LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {2}}};

  Preparing() {
    counts->beforeInfluence = [this, here = std::this_thread::get_id(), open = gate.get_future().share()] {
      if (std::this_thread::get_id() == here)
        ++madeHere;
      else
        open.wait();
    };
    registry.add(std::make_shared<viscera::tests::CountingSystem>(counts), "test");
    undo.perform(document::setSystem({"counting", {}}));
    undo.perform(document::setVolumeLocked(organ(), true));
  }
  void go() { gate.set_value(); }
  void finishJobs() {
    box.runUntil([this] { return jobs.idle(); });
  }
  /// Turns a handle under the lock, from rest, and says how many gradients of the surface that took.
  int turn(VolumeKeeper& keeper) {
    LockedMotion motion = keeper.begin({handle(9), handle(1)});
    const int before = counts->pullBacks;
    const Points& pose = motion.rotate(Vec3::Zero(), Vec3::UnitZ(), 0.4);
    EXPECT_EQ(motion.obstacle().english(), "");
    const int taken = counts->pullBacks - before;
    undo.perform(document::setPose(pose));
    EXPECT_LE(std::abs(live.volume(organ()).relativeChange()), 1e-12);
    turned = document.pose();
    undo.undo();
    return taken;
  }
  Points turned;
};

TEST(VolumeKeeper, AMotionThatBeginsBeforeTheFormIsThereNeitherMakesItNorWaits) {
  Preparing s;
  VolumeKeeper keeper(s.document.state(), s.live, {2}, &s.jobs);
  keeper.prepare();
  EXPECT_EQ(s.jobs.jobs().size(), 1u);
  EXPECT_GT(s.turn(keeper), 0) << "it passes over the surface";
  const Points early = s.turned;
  EXPECT_EQ(s.jobs.jobs().size(), 1u) << "the one that is under way is wanted still";
  s.go();
  s.finishJobs();
  EXPECT_EQ(s.turn(keeper), 0) << "the form is there";
  EXPECT_EQ(s.madeHere, 0);
  EXPECT_LT((s.turned - early).cwiseAbs().maxCoeff(), 1e-8);
  keeper.prepare();
  EXPECT_TRUE(s.jobs.idle()) << "what is ready is made again";
}

TEST(VolumeKeeper, WithoutFormsEachPoseThatIsTriedTakesOnePassOverEachSurface) {
  Preparing s;
  s.undo.perform(document::addOrgans({ball("Second", 9, 2, {12, 0, 0})}));
  s.undo.perform(document::setVolumeLocked(s.organ(1), true));
  VolumeKeeper keeper(s.document.state(), s.live, {2}, &s.jobs);
  LockedMotion motion = keeper.begin({s.handle(9)});
  const int deforms = s.counts->deforms;
  const int pullBacks = s.counts->pullBacks;
  const Points& pose = motion.translate({5, 1, 2});
  EXPECT_EQ(motion.obstacle().english(), "");
  const int gradients = s.counts->pullBacks - pullBacks;
  EXPECT_GE(gradients, 4);
  EXPECT_LE(s.counts->deforms - deforms, gradients + 2) << "the wish, and where each step leads";
  s.undo.perform(document::setPose(pose));
  for (const std::size_t place : {0, 1})
    EXPECT_LE(std::abs(s.live.volume(s.organ(place)).relativeChange()), 1e-12) << place;
  s.go();
}

TEST(VolumeKeeper, TwoKeepersPrepareOnOneQueueWithoutGivingUpEachOthersWork) {
  Preparing s;
  VolumeKeeper drags(s.document.state(), s.live, {2}, &s.jobs);
  VolumeKeeper plays(s.document.state(), s.live, {2}, &s.jobs);
  drags.prepare();
  plays.prepare();
  s.go();
  s.finishJobs();
  EXPECT_EQ(s.turn(drags), 0);
  EXPECT_EQ(s.turn(plays), 0);
}

TEST(VolumeKeeper, GivesUpTheFormOfAnOrganThatIsNoLongerLocked) {
  Preparing s;
  VolumeKeeper keeper(s.document.state(), s.live, {2}, &s.jobs);
  keeper.prepare();
  s.undo.perform(document::setVolumeLocked(s.organ(), false));
  keeper.dropOutdated();
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  s.go();
  s.finishJobs();
  EXPECT_GT(s.turn(keeper), 0) << "it was made all the same";
}

TEST(VolumeKeeper, GivesUpTheFormOfABindingThatIsReplaced) {
  Preparing s;
  VolumeKeeper keeper(s.document.state(), s.live, {2}, &s.jobs);
  keeper.prepare();
  const std::weak_ptr<const coordinates::Binding> old = s.live.bound(s.organ())->sharedBinding();
  s.undo.perform(document::moveRestHandles({s.handle(9)}, tests::row(44, 3, -1)));
  keeper.dropOutdated();
  s.go();
  s.finishJobs();
  keeper.prepare();
  s.finishJobs();
  EXPECT_EQ(s.turn(keeper), 0) << "the new one was prepared";
  EXPECT_TRUE(old.expired());
}

TEST(VolumeKeeper, MayGoWhileAFormIsUnderWay) {
  Preparing s;
  std::optional<VolumeKeeper> keeper(std::in_place, s.document.state(), s.live, Threads{2}, &s.jobs);
  keeper->prepare();
  keeper.reset();
  s.go();
  s.finishJobs();
}

TEST(VolumeKeeper, WithoutAJobQueueTheFirstMotionMakesTheFormAndTheNextOneHasIt) {
  Preparing s;
  VolumeKeeper keeper(s.document.state(), s.live, {2});
  keeper.prepare();
  EXPECT_TRUE(s.jobs.idle());
  EXPECT_EQ(s.turn(keeper), 0);
  EXPECT_EQ(s.madeHere, 10) << "a column for each handle";
  EXPECT_EQ(s.turn(keeper), 0);
  EXPECT_EQ(s.madeHere, 10);
}

TEST(VolumeKeeper, ADragWithoutALockComputesNoGradientOfTheVolume) {
  Preparing s;
  VolumeKeeper keeper(s.document.state(), s.live, {2}, &s.jobs);
  s.undo.perform(document::setVolumeLocked(s.organ(), false));
  const int before = s.counts->pullBacks;
  {
    document::UndoStack::Step step(s.undo, "Drag");
    LockedMotion motion = keeper.begin({s.handle(9)}, deformation::MirrorPlane());
    for (int i = 1; i < 4; ++i) {
      s.undo.perform(document::setPose(motion.translate({1.0 * i, 0.5, 0})));
      EXPECT_GT(s.live.volume(s.organ()).nowMl, 0);
    }
    step.finish();
  }
  LockedMotion turned = keeper.begin({s.handle(9), s.handle(1)});
  s.undo.perform(document::setPose(turned.rotate(Vec3::Zero(), Vec3::UnitZ(), 0.4)));
  EXPECT_EQ(s.counts->pullBacks, before);
  EXPECT_EQ(s.counts->influences, 0);
  s.live.deformer(s.organ())->volumeGradient();
  EXPECT_EQ(s.counts->pullBacks, before + 1) << "whoever looks at it has it computed";
}

} // namespace
} // namespace viscera::live
