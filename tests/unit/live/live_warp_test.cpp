#include "viscera/live/live_warp.h"

#include <limits>

#include <gtest/gtest.h>

#include "phantom_scan.h"
#include "session_fixture.h"
#include "viscera/document/scan_item.h"

namespace viscera::live {
namespace {

struct BentBall : tests::BoundSession {
  LiveWarp warp{document, live, registry, jobs, {.refineSeconds = std::numeric_limits<double>::infinity()}};

  /// All handles that much farther on.
  void shift(const Vec3& by) {
    std::vector<document::HandleId> all;
    Points moved = document.rig().restPositions();
    moved.rowwise() += by.transpose();
    for (const document::Handle& handle : document.rig().handles)
      all.push_back(handle.id);
    undo.perform(document::moveHandles(all, moved));
  }
  Vec3 restOf(const Vec3& place) {
    Points points(1, 3);
    points.row(0) = place.transpose();
    return warp.map()->restPoints(points).points.row(0).transpose();
  }
  void wait() {
    box.runUntil([this] { return warp.map() != nullptr; });
  }
};

TEST(LiveWarp, SaysWhereTissueWasInThePoseThatIsShown) {
  BentBall ball;
  ball.warp.setWanted(true);
  EXPECT_EQ(ball.warp.map(), nullptr) << "nothing is warped at rest";
  EXPECT_TRUE(ball.jobs.idle()) << "and nothing is bound for it";
  ball.shift(Vec3(0, 0, 10));
  ball.wait();
  EXPECT_LT((ball.restOf(Vec3(3, 2, 15)) - Vec3(3, 2, 5)).norm(), 0.1);
  const std::uint64_t before = ball.warp.revision();
  ball.shift(Vec3(6, 0, 0));
  EXPECT_LT((ball.restOf(Vec3(3, 2, 15)) - Vec3(-3, 2, 15)).norm(), 0.1) << "another pose needs no binding";
  EXPECT_NE(ball.warp.revision(), before);
  EXPECT_TRUE(ball.jobs.idle());
  ball.live.showRest();
  EXPECT_EQ(ball.warp.map(), nullptr);
}

TEST(LiveWarp, BindsNothingUnlessSomebodyLooksAndAnewForOtherHandles) {
  BentBall ball;
  ball.shift(Vec3(0, 0, 10));
  EXPECT_TRUE(ball.jobs.idle());
  ball.warp.setWanted(true);
  ball.wait();
  const auto* first = ball.warp.map();
  ball.undo.perform(document::addHandles({{Vec3(-35, 1, 2)}}));
  EXPECT_EQ(ball.warp.map(), nullptr) << "what there was belongs to other handles";
  ball.shift(Vec3(0, 0, 10));
  ball.wait();
  EXPECT_NE(first, nullptr);
  EXPECT_LT((ball.restOf(Vec3(3, 2, 15)) - Vec3(3, 2, 5)).norm(), 0.1);
}

TEST(LiveWarp, SaysItAsExactlyFarFromTheFirstPoseAsNearIt) {
  BentBall ball;
  ball.warp.setWanted(true);
  ball.shift(Vec3(0, 0, 1)); // The first pose, for which the grid is made: any grid is exact for it.
  ball.wait();
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(4, 6, 62)));
  const deformation::SamplePlane plane{{-20, 3, -20}, {0.5, 0, 0}, {0, 0, 0.5}, 80, 90};
  deformation::RestPoints rest;
  ball.warp.restPlane(plane, rest);
  const auto target = ball.registry.find(ball.document.system().id);
  Points posed(plane.columns * plane.rows, 3);
  for (Eigen::Index i = 0; i < posed.rows(); ++i)
    posed.row(i) = plane.at(i % plane.columns, i / plane.columns).transpose();
  Progress progress;
  EXPECT_LT(ball.warp.map()->residualMm(*target, posed, rest, progress), 2 * kWarpToleranceMm);
  EXPECT_EQ(ball.warp.foldedMl(), 0);
  // A finer grid is bound beside it, and takes its place.
  ball.box.runUntil([&] { return ball.jobs.idle(); });
  EXPECT_FALSE(ball.warp.map()->wantsFinerGrid());
}

TEST(LiveWarp, HasNoMapWhenItsSystemGoesWhileItIsBound) {
  BentBall ball;
  ball.warp.setWanted(true);
  ball.shift(Vec3(0, 0, 10));
  EXPECT_FALSE(ball.jobs.idle());
  const document::SystemChoice before = ball.document.system();
  ball.undo.perform(document::setSystem({"of-a-plugin-that-is-gone", {}}));
  EXPECT_EQ(ball.warp.map(), nullptr);
  ball.box.runUntil([&] { return ball.jobs.idle(); });
  EXPECT_EQ(ball.warp.map(), nullptr) << "there is no system that could refine it";
  EXPECT_NE(ball.warp.problem().english(), "");
  ball.undo.perform(document::setSystem(before));
  ball.wait();
  EXPECT_EQ(ball.warp.problem().english(), "");
}

TEST(LiveWarp, MovesMeasuredPlacesAsItShowsTheScanAndOnlyWhileItDoes) {
  BentBall ball;
  EXPECT_EQ(ball.warp.posedOf(Vec3(3, 2, 5)), Vec3(3, 2, 5)) << "nothing is warped yet";
  int changes = 0;
  const Subscription counted = ball.warp.onChange([&] { ++changes; });
  ball.warp.setWanted(true);
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(4, 6, 52)));
  ball.wait();
  const Vec3 rest(2, 1, 25), posed = ball.warp.posedOf(rest);
  EXPECT_GT((posed - rest).norm(), 1);
  EXPECT_LT((ball.restOf(posed) - rest).norm(), 0.05);
  EXPECT_LT((ball.warp.restOf(posed) - rest).norm(), 0.05);
  EXPECT_FALSE(tissueMotionOf(ball.warp)) << "without a scan a place stays where it is";
  ball.undo.perform(document::openScan(
      document::scanItem(tests::phantomScan({9, 9, 9}, Vec3(10, 10, 10), Vec3(-40, -40, -40),
                                            tests::ballValue(Vec3::Zero(), 30)),
                         {})));
  ASSERT_TRUE(tissueMotionOf(ball.warp));
  EXPECT_EQ(tissueMotionOf(ball.warp)(rest), posed);
  document::MeasuredPoint point;
  point.rest = rest;
  document::Measurement distance;
  distance.points = {point, point};
  const document::TissueMotion kept = measuredTissueOf(ball.warp, {distance});
  EXPECT_EQ(kept(rest), posed);
  const int before = changes;
  ball.warp.setWanted(false);
  EXPECT_EQ(changes, before + 1) << "who measures has to know";
  EXPECT_FALSE(tissueMotionOf(ball.warp));
  EXPECT_EQ(kept(rest), posed) << "another thread has it for itself";
}

TEST(LiveWarp, BendsNoOrganInTheScanThatDoesNotBend) {
  BentBall ball;
  const document::OrganId soft = ball.organ();
  ball.undo.perform(document::addOrgans({tests::ball("Left femur", 8, 3, Vec3(0, 0, 20))}));
  const document::OrganId bone = ball.organ(1);
  ASSERT_EQ(ball.document.organ(bone)->mobility, document::Mobility::rigid);
  ball.warp.setWanted(true);
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(10, 0, 62)));
  ball.wait();
  const auto farthest = [&](document::OrganId organ) {
    double most = 0;
    const Points& rest = ball.document.organ(organ)->mesh->points;
    for (Eigen::Index i = 0; i < rest.rows(); i += 5) {
      const Vec3 place = ball.live.points(organ).row(i).transpose();
      most = std::max(most, (ball.warp.restOf(place) - rest.row(i).transpose()).norm());
    }
    return most;
  };
  EXPECT_LT(farthest(bone), 1e-6) << "its image goes with its surface";
  const std::uint64_t before = ball.warp.revision();
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(-8, 4, 58)));
  EXPECT_LT(farthest(bone), 1e-6) << "in the next pose, too";
  EXPECT_NE(ball.warp.revision(), before);
  ball.undo.perform(document::setMobility({bone}, document::Mobility::bends));
  ball.wait();
  EXPECT_GT(farthest(bone) + farthest(soft), 0);
  const Vec3 place = ball.live.points(bone).row(0).transpose();
  EXPECT_LT((ball.warp.restOf(place) - ball.restOf(place)).norm(), 1e-9) << "as soft tissue now";
}

TEST(LiveWarp, CountsWhatThePoseFolds) {
  BentBall ball;
  ball.warp.setWanted(true);
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(0, 0, -90)));
  ball.wait();
  EXPECT_GT(ball.warp.foldedMl(), 0.5);
  EXPECT_LT(ball.warp.foldedMl(), 150);
}

} // namespace
} // namespace viscera::live
