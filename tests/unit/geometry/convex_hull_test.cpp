#include "viscera/geometry/convex_hull.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

Points randomPoints(int count, double size, const Vec3& center, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-size, size);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i)
    points.data()[i] = coordinate(random);
  points.rowwise() += center.transpose();
  return points;
}

TEST(ConvexHull, OfABoxHasItsVolumeAndSixPlanes) {
  const auto box = tests::box(2, 3, 5);
  const ConvexHull hull(box.points);
  EXPECT_EQ(hull.planes().rows(), 6);
  EXPECT_NEAR(volume(box.points, hull.triangles()), 30, 1e-12);
}

TEST(ConvexHull, SignedDistanceIsNegativeInsideAndPositiveOutside) {
  const ConvexHull hull(tests::box(2, 2, 2).points);
  EXPECT_NEAR(hull.signedDistance({1, 1, 1}), -1, 1e-14);
  EXPECT_NEAR(hull.signedDistance({1, 1, 2.5}), 0.5, 1e-14);
}

TEST(ConvexHull, ContainsItsPointsFarFromTheOrigin) {
  const Points points = randomPoints(300, 50, {1e4, -2e4, 3e4}, 11);
  const ConvexHull hull(points);
  EXPECT_TRUE(hull.outside(points, 1e-9 * hull.diagonal()).empty());
  EXPECT_GT(volume(points, hull.triangles()), 0);
}

TEST(ConvexHull, ListsThePointsOutside) {
  const ConvexHull hull(tests::box(1, 1, 1).points);
  Points points(3, 3);
  points << 0.5, 0.5, 0.5, 1.5, 0.5, 0.5, 0.5, -0.1, 0.5;
  EXPECT_EQ(hull.outside(points), (std::vector<int>{1, 2}));
}

TEST(ConvexHull, RefusesFewerThanFourPoints) {
  EXPECT_THROW(ConvexHull(randomPoints(3, 1, Vec3::Zero(), 1)), DataError);
  EXPECT_THROW(ConvexHull(Points(0, 3)), DataError);
}

TEST(ConvexHull, RefusesPointsInOnePlane) {
  Points points = randomPoints(20, 10, {100, 100, 100}, 3);
  points.col(2) = 0.5 * points.col(0) - 0.25 * points.col(1);
  EXPECT_THROW(ConvexHull{points}, DataError);
}

TEST(ConvexHull, RefusesPointsAtOnePlaceAndPointsThatAreNotFinite) {
  EXPECT_THROW(ConvexHull(Points::Constant(5, 3, 2.0)), DataError);
  Points points = randomPoints(8, 1, Vec3::Zero(), 5);
  points(4, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ConvexHull{points}, DataError);
}

} // namespace
} // namespace viscera::geometry
