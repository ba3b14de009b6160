#include "viscera/sequences/breathing.h"

#include <algorithm>
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
  double end = 0;
  for (const Phase& phase : phases) {
    EXPECT_EQ(phase.begin, end);
    end = phase.end;
  }
  EXPECT_EQ(end, 1);
}

TEST(LiverBreathing, phasesSayWhatTheLiverDoes) {
  const LiverBreathing breathing(someHandles(), kLiver);
  constexpr double kRate = 15, kPeriod = 60 / kRate;
  double in = 0, out = 0, rest = 0;
  for (const Phase& phase : breathing.phases(kRate)) {
    const double before = breathing.inspiration(phase.begin * kPeriod, kRate);
    const double after = breathing.inspiration(phase.end * kPeriod, kRate);
    const double length = phase.end - phase.begin;
    if (phase.name.english() == "inspiration") {
      EXPECT_GT(after - before, 0.97);
      in += length;
    } else if (phase.name.english() == "expiration") {
      EXPECT_LT(after - before, -0.97);
      out += length;
    } else {
      EXPECT_EQ(phase.name.english(), "pause");
      EXPECT_LT(std::max(before, after), 0.02) << "nothing moves in a pause";
      rest += length;
    }
  }
  EXPECT_NEAR((out + rest) / in, 1.6, 0.1);
  EXPECT_LT(rest, out);
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
