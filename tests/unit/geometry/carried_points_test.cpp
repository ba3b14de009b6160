#include "viscera/geometry/carried_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "shapes.h"

namespace viscera::geometry {
namespace {

constexpr double kExact = 1e-9;

struct CarriedPointsTest : testing::Test {
  Points surface = tests::sphere(4, 30, Vec3::Zero()).points;
  Points points = [] {
    Points made(2, 3);
    made << 31, 0, 0, 0, 28, 5;
    return made;
  }();
};

TEST_F(CarriedPointsTest, StayWhereTheSurfaceIsAtRest) {
  EXPECT_LT((CarriedPoints(points, surface).at(surface) - points).cwiseAbs().maxCoeff(), kExact);
}

TEST_F(CarriedPointsTest, GoWithASurfaceThatIsMoved) {
  const Eigen::RowVector3d away(3, -4, 12);
  const Points moved = surface.rowwise() + away;
  EXPECT_LT((CarriedPoints(points, surface).at(moved) - (points.rowwise() + away)).cwiseAbs().maxCoeff(),
            kExact);
}

TEST_F(CarriedPointsTest, GoWithTheNearPartOfIt) {
  Points moved = surface;
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
    if (moved(i, 0) > 0)
      moved(i, 0) += 0.2 * moved(i, 0);
  const Points carried = CarriedPoints(points, surface).at(moved);
  EXPECT_NEAR(carried(0, 0) - points(0, 0), 6, 1) << "a fifth of 30 mm, less beside its end";
  EXPECT_LT((carried.row(1) - points.row(1)).norm(), 1);
}

TEST_F(CarriedPointsTest, OfASurfaceWithFewVerticesGoWithThemAll) {
  Points three(3, 3);
  three << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  const Points carried = CarriedPoints(points, three).at(2 * three);
  EXPECT_TRUE(carried.allFinite());
}

} // namespace
} // namespace viscera::geometry
