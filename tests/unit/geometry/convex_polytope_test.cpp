#include "viscera/geometry/convex_polytope.h"

#include <random>

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

constexpr double kTolerance = 1e-8;

ConvexPolytope boxAt(const Vec3& low, const Vec3& size) {
  Points corners = tests::box(size[0], size[1], size[2]).points;
  corners.rowwise() += low.transpose();
  return ConvexPolytope::hullOf(corners, kTolerance);
}

Points row(std::initializer_list<Vec3> list) {
  Points points(static_cast<Eigen::Index>(list.size()), 3);
  Eigen::Index i = 0;
  for (const Vec3& p : list)
    points.row(i++) = p.transpose();
  return points;
}

double volumeOf(const ConvexPolytope& polytope) {
  return volume(polytope.vertices(), polytope.triangles());
}

TEST(ConvexPolytope, KnowsItsDimension) {
  EXPECT_EQ(boxAt({0, 0, 0}, {1, 2, 3}).dimension(), 3);
  EXPECT_EQ(ConvexPolytope::hullOf(row({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}), kTolerance).dimension(),
            2);
  EXPECT_EQ(ConvexPolytope::hullOf(row({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), kTolerance).dimension(), 1);
  EXPECT_EQ(ConvexPolytope::hullOf(row({{5, 5, 5}, {5, 5, 5}}), kTolerance).dimension(), 0);
}

TEST(ConvexPolytope, BoxesThatOverlapShareABox) {
  const auto common = boxAt({0, 0, 0}, {2, 2, 2}).intersection(boxAt({1, 1, 1}, {3, 3, 3}));
  ASSERT_TRUE(common);
  EXPECT_EQ(common->dimension(), 3);
  EXPECT_NEAR(volumeOf(*common), 1, 1e-6);
}

TEST(ConvexPolytope, BoxesThatTouchShareAFaceAnEdgeOrACorner) {
  const auto box = boxAt({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(box.intersection(boxAt({1, 0, 0}, {1, 1, 1}))->dimension(), 2);
  EXPECT_EQ(box.intersection(boxAt({1, 0.25, 0.25}, {1, 0.5, 0.5}))->dimension(), 2);
  EXPECT_EQ(box.intersection(boxAt({1, 1, 0}, {1, 1, 1}))->dimension(), 1);
  EXPECT_EQ(box.intersection(boxAt({1, 1, 1}, {1, 1, 1}))->dimension(), 0);
  EXPECT_FALSE(box.intersection(boxAt({1.001, 0, 0}, {1, 1, 1})));
}

TEST(ConvexPolytope, ABoxInsideAnotherIsTheWholeIntersection) {
  const auto common = boxAt({0, 0, 0}, {9, 9, 9}).intersection(boxAt({3, 3, 3}, {1, 2, 1}));
  ASSERT_TRUE(common);
  EXPECT_NEAR(volumeOf(*common), 2, 1e-6);
}

TEST(ConvexPolytope, FlatSetsIntersectAsWell) {
  const auto face = ConvexPolytope::hullOf(row({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}), kTolerance);
  const auto wall = ConvexPolytope::hullOf(row({{1, 0, -1}, {1, 2, -1}, {1, 2, 1}, {1, 0, 1}}), kTolerance);
  const auto line = face.intersection(wall);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->dimension(), 1);
  EXPECT_NEAR((line->vertices().row(0) - line->vertices().row(1)).norm(), 2, 1e-6);
  const auto point = ConvexPolytope::hullOf(row({{1, 1, 0}}), kTolerance);
  EXPECT_TRUE(face.intersection(point));
  EXPECT_FALSE(wall.intersection(ConvexPolytope::hullOf(row({{1.5, 1, 0}}), kTolerance)));
}

TEST(ConvexPolytope, IntersectionsHoldExactlyThePointsInBoth) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto cloud = [&](const Vec3& center) {
    Points points(12, 3);
    for (Eigen::Index i = 0; i < points.size(); ++i)
      points.data()[i] = coordinate(random);
    points.rowwise() += center.transpose();
    return ConvexPolytope::hullOf(points, kTolerance);
  };
  for (int trial = 0; trial < 40; ++trial) {
    const auto a = cloud(Vec3::Zero()), b = cloud({0.6, 0.2, -0.3});
    const auto common = a.intersection(b);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = tests::drawPlace(coordinate, random);
      const double both = std::max(a.signedDistance(p), b.signedDistance(p));
      if (std::abs(both) > 1e-6) {
        EXPECT_EQ(common.has_value() && common->contains(p), both < 0);
      }
    }
  }
}

TEST(ConvexPolytope, ClosestPointsAreNearerThanAnyOther) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  const auto box = boxAt({-1, -1, -1}, {2, 2, 2});
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = tests::drawPlace(coordinate, random);
    const Vec3 exact = p.cwiseMax(-1.0).cwiseMin(1.0);
    EXPECT_LT((box.closestPoint(p) - exact).norm(), 1e-7);
  }
  const auto segment = ConvexPolytope::hullOf(row({{0, 0, 0}, {4, 0, 0}}), kTolerance);
  EXPECT_LT((segment.closestPoint({5, 1, 0}) - Vec3(4, 0, 0)).norm(), 1e-12);
  EXPECT_LT((segment.closestPoint({2, 1, 0}) - Vec3(2, 0, 0)).norm(), 1e-12);
}

} // namespace
} // namespace viscera::geometry
