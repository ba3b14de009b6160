#include "viscera/geometry/carried_points.h"

#include <cmath>

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

/// A ball of 30 mm with a smaller one in it, which carry points between and in them.
struct Balls {
  Points outer = tests::sphere(4, 30).points;
  Points inner = tests::sphere(3, 12, Vec3(2, -3, 4)).points;
  Points vertices = both(outer, inner);
  Points rest = tests::onSphere(200, 20);

  static Points both(const Points& a, const Points& b) {
    Points all(a.rows() + b.rows(), 3);
    all << a, b;
    return all;
  }
};

template <class Motion>
Points moved(const Points& points, const Motion& motion) {
  Points out(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    out.row(i) = motion(Vec3(points.row(i).transpose())).transpose();
  return out;
}

template <class Motion>
double worstError(const Balls& balls, const Motion& motion) {
  const CarriedPoints carried(balls.rest, balls.vertices);
  Points now;
  carried.at(moved(balls.vertices, motion), now);
  return (now - moved(balls.rest, motion)).rowwise().norm().maxCoeff();
}

TEST(CarriedPoints, StayWhereTheyAreWhileNothingMoves) {
  EXPECT_LT(worstError(Balls(), [](const Vec3& p) { return p; }), 1e-5);
}

TEST(CarriedPoints, FollowTurnsAndStretchesOfAllVertices) {
  Eigen::Matrix3d stretch;
  stretch << 1.3, 0.2, -0.1, -0.3, 0.8, 0.1, 0.05, 0.2, 1.1;
  EXPECT_LT(worstError(Balls(), [&](const Vec3& p) -> Vec3 { return stretch * p + Vec3(40, -7, 12); }), 1e-4);
}

TEST(CarriedPoints, FollowABendWithinAnEighthOfItsSize) {
  const auto bend = [](const Vec3& p) -> Vec3 { return p + Vec3(0, 0, 0.01 * p.x() * p.x()); };
  EXPECT_LT(worstError(Balls(), bend), 9.0 / 8) << "of 9 mm at the edge";
}

TEST(CarriedPoints, AreTheVertexWhosePlaceTheyHave) {
  const Balls balls;
  const CarriedPoints carried(balls.outer, balls.vertices);
  const Points elsewhere = moved(balls.vertices, [](const Vec3& p) -> Vec3 {
    return p + Vec3(std::sin(p.y()), std::cos(p.x()), p.z());
  });
  Points now;
  carried.at(elsewhere, now);
  EXPECT_TRUE(now == elsewhere.topRows(balls.outer.rows()));
  for (Eigen::Index i = 0; i < carried.size(); ++i)
    ASSERT_TRUE(carried.isVertex(i));
  EXPECT_FALSE(CarriedPoints(balls.rest, balls.vertices).isVertex(0));
}

TEST(CarriedPoints, DoNotDependOnTheNumberOfThreads) {
  const Balls balls;
  Points one, three;
  CarriedPoints(balls.rest, balls.vertices, Threads{1}).at(1.5 * balls.vertices, one, Threads{1});
  CarriedPoints(balls.rest, balls.vertices, Threads{3}).at(1.5 * balls.vertices, three, Threads{3});
  EXPECT_TRUE(one == three);
}

TEST(CarriedPoints, GoAlongWithAFlatSheet) {
  Points sheet(25, 3);
  for (int i = 0; i < 25; ++i)
    sheet.row(i) << i % 5, i / 5, 0; // NOLINT(bugprone-integer-division)
  Points over(1, 3);
  over << 2.3, 1.7, 0.4;
  const CarriedPoints carried(over, sheet);
  Points now;
  carried.at(sheet.rowwise() + Eigen::RowVector3d(3, 4, 5), now);
  EXPECT_LT((now.row(0) - Eigen::RowVector3d(5.3, 5.7, 5)).head<2>().norm(), 1e-3);
  EXPECT_TRUE(now.allFinite());
}

TEST(CarriedPoints, RefuseTooFewVerticesAndOthers) {
  const Balls balls;
  EXPECT_THROW(CarriedPoints(balls.rest, balls.vertices.topRows(3)), DataError);
  const CarriedPoints carried(balls.rest, balls.vertices);
  Points out;
  EXPECT_THROW(carried.at(balls.outer, out), UsageError);
}

} // namespace
} // namespace viscera::geometry
