#include "viscera/sequences/breathing.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

const Bounds kLiver{{-110, -80, -90}, {70, 60, 60}};

Points someHandles() {
  Points points(6, 3);
  points << -110, 0, 0, 70, 0, 0, 0, -80, 0, 0, 60, 0, 0, 0, -90, 0, 0, 60;
  return points;
}

TEST(LiverBreathing, restsAtTheEndOfExpiration) {
  const LiverBreathing breathing(someHandles(), kLiver);
  Points pose;
  for (const double seconds : {0.0, 4.0, 20.0}) {
    breathing.poseAt(seconds, 15, pose);
    EXPECT_LT((pose - someHandles()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(LiverBreathing, movesDownAndForwardAsFarAsMeasuredInPeople) {
  const LiverBreathing breathing(someHandles(), kLiver);
  const Vec3 way = breathing.moved(kLiver.center(), 1) - kLiver.center();
  EXPECT_LT(way.z(), -10);
  EXPECT_GT(way.z(), -25);
  EXPECT_LT(way.y(), 0);
  EXPECT_GT(-way.z(), 2 * std::abs(way.y()));
}

TEST(LiverBreathing, domeGoesFartherThanTheEdgeAndTheRightFartherThanTheLeft) {
  const LiverBreathing breathing(someHandles(), kLiver);
  const auto down = [&](const Vec3& point) { return point.z() - breathing.moved(point, 1).z(); };
  EXPECT_GT(down({0, 0, 60}), down({0, 0, -90}) + 5);
  EXPECT_GT(down({-110, 0, 0}), down({70, 0, 0}) + 3);
}

TEST(LiverBreathing, keepsEveryVolume) {
  const LiverBreathing breathing(someHandles(), kLiver);
  for (const double drawn : {0.0, 0.3, 1.0}) {
    const Vec3 origin = breathing.moved(Vec3::Zero(), drawn);
    Eigen::Matrix3d map;
    for (int axis = 0; axis < 3; ++axis)
      map.col(axis) = breathing.moved(Vec3::Unit(axis), drawn) - origin;
    EXPECT_NEAR(map.determinant(), 1, 1e-12);
  }
}

TEST(LiverBreathing, spendsMoreTimeOutThanIn) {
  const LiverBreathing breathing(someHandles(), kLiver);
  int in = 0;
  for (int k = 0; k < 100; ++k)
    in += breathing.inspiration(k * 0.04, 15) > 0.5 ? 1 : 0;
  EXPECT_LT(in, 45);
  EXPECT_NEAR(breathing.inspiration(2, 15), 1, 1e-12);
  EXPECT_NEAR(breathing.inspiration(3.3, 15), breathing.inspiration(3.3 + 8, 15), 1e-9);
}

TEST(LiverBreathing, phasesCoverABreath) {
  const std::vector<Phase> phases = LiverBreathing(someHandles(), kLiver).phases(15);
  ASSERT_EQ(phases.size(), 3u);
  EXPECT_EQ(phases[0].begin, 0);
  EXPECT_EQ(phases[1].begin, phases[0].end);
  EXPECT_EQ(phases[2].begin, phases[1].end);
  EXPECT_EQ(phases[2].end, 1);
}

TEST(LiverBreathing, refusesWhatCannotBreathe) {
  EXPECT_THROW(LiverBreathing(Points(3, 3), kLiver), DataError);
  EXPECT_THROW(LiverBreathing(someHandles(), Bounds{}), DataError);
  LiverExcursion flat;
  flat.domeShare = 1;
  EXPECT_THROW(LiverBreathing(someHandles(), kLiver, {}, flat), DataError);
}

} // namespace
} // namespace viscera::sequences
