#include "viscera/tracking/rims.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace viscera::tracking {
namespace {

Points square(double half) {
  Points points(4, 3);
  points << -half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0;
  return points;
}

TEST(Rims, AreNearestWhereALineIsAndRunAlongIt) {
  const Points rim = square(10);
  const PlaceOnRim side = nearestOnRim(rim, Vec3(3, 14, 5));
  EXPECT_LT((side.point - Vec3(3, 10, 0)).norm(), 1e-12);
  EXPECT_NEAR(std::abs(side.direction.x()), 1, 1e-12);
  const PlaceOnRim closing = nearestOnRim(rim, Vec3(-11, 2, 0));
  EXPECT_LT((closing.point - Vec3(-10, 2, 0)).norm(), 1e-12) << "from the last point to the first";
  EXPECT_LT((nearestOnRim(rim, Vec3(20, 20, 1)).point - Vec3(10, 10, 0)).norm(), 1e-12);
}

TEST(Rims, HaveTheLengthOfTheirEdges) {
  const Values lengths = lengthsAlong(square(10));
  EXPECT_NEAR(lengths.sum(), 80, 1e-12);
  EXPECT_NEAR(lengths[2], 20, 1e-12);
}

/// A surface with three rims: two valves, and one triangle that is missing.
struct TwoValves {
  TwoValves(double apart, bool turned) {
    mesh.points.resize(11, 3);
    mesh.points.topRows(4) = square(10);
    mesh.points.middleRows(4, 4) = square(7).rowwise() + Eigen::RowVector3d(apart, 0, 0);
    mesh.points.bottomRows(3) << 0, 0, 50, 1, 0, 50, 0, 1, 50;
    rims = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10}};
    if (turned)
      std::reverse(rims.begin(), rims.end());
  }
  RimmedSurface surface() const { return {&mesh, &rims}; }

  geometry::TriangleMesh mesh;
  std::vector<Rim> rims;
};

TEST(Rims, AreTheSameValvesInEveryPhaseWhateverTheirOrder) {
  const TwoValves one(30, false), two(26, true), three(22, false);
  const auto common = commonRims({one.surface(), two.surface(), three.surface()});
  ASSERT_EQ(common.size(), 3U);
  for (const std::vector<Rim>& rims : common) {
    ASSERT_EQ(rims.size(), 2U) << "a missing triangle is no valve";
    EXPECT_EQ(rims[0].front(), 0);
    EXPECT_EQ(rims[1].front(), 4);
  }
}

TEST(Rims, AreNoneWhereAPhaseLacksOne) {
  const TwoValves one(30, false);
  TwoValves two(30, false);
  two.rims.erase(two.rims.begin());
  EXPECT_TRUE(commonRims({one.surface(), two.surface()}).empty());
}

} // namespace
} // namespace viscera::tracking
