#include "viscera/geometry/tube_axis.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "shapes.h"
#include "tubes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::geometry {
namespace {

double distanceFromLine(const tests::StomachTube& tube, const Vec3& point) {
  double least = 1e9;
  for (int i = 0; i <= 1000; ++i)
    least = std::min(least, (tube.center(i / 1000.0) - point).norm());
  return least;
}

TEST(TubeAxis, theTubeOfTheTestsIsAClosedSurface) {
  const SurfaceReport report = checkSurface(tests::StomachTube().mesh());
  EXPECT_TRUE(report.closed() && report.manifold() && report.outward());
}

TEST(TubeAxis, followsTheMiddleOfABentTaperedTubeWhereverItLies) {
  tests::StomachTube tube;
  tube.scale = 0.7;
  tube.rotation = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  tube.shift = {40, -300, 12};
  const TriangleMesh mesh = tube.mesh();
  const TubeEnds ends = tubeEnds(mesh);
  EXPECT_LT((mesh.points.row(ends.wide).transpose() - tube.center(0)).norm(), 0.7 * 30);
  EXPECT_LT((mesh.points.row(ends.narrow).transpose() - tube.center(1)).norm(), 0.7 * 15);
  const TubeAxis axis = tubeAxis(mesh, ends.wide, ends.narrow);
  ASSERT_GE(axis.points.size(), 15u);
  for (std::size_t i = 2; i + 2 < axis.points.size(); ++i)
    EXPECT_LT(distanceFromLine(tube, axis.points[i]), 0.7 * 6) << i;
}

TEST(TubeAxis, slicesHaveTheAreaOfTheTube) {
  const tests::StomachTube tube;
  const TriangleMesh mesh = tube.mesh();
  const TubeEnds ends = tubeEnds(mesh);
  const TubeAxis axis = tubeAxis(mesh, ends.wide, ends.narrow);
  for (std::size_t i = 3; i + 3 < axis.points.size(); ++i) {
    double at = 0;
    for (int k = 0; k <= 1000; ++k)
      if ((tube.center(k / 1000.0) - axis.points[i]).norm() < (tube.center(at) - axis.points[i]).norm())
        at = k / 1000.0;
    const double wanted = std::numbers::pi * tube.radius(at) * tube.radius(at);
    EXPECT_NEAR(axis.areas[i], wanted, 0.15 * wanted) << i;
  }
}

TEST(TubeAxis, refusesTwoEndsAtOnePlaceOrOnTwoPieces) {
  const TriangleMesh ball = tests::sphere(2, 10);
  EXPECT_THROW(tubeAxis(ball, 3, 3), DataError);
  TriangleMesh two = ball;
  two.points.conservativeResize(2 * ball.points.rows(), 3);
  two.points.bottomRows(ball.points.rows()) = ball.points.rowwise() + Eigen::RowVector3d(50, 0, 0);
  two.triangles.conservativeResize(2 * ball.triangles.rows(), 3);
  two.triangles.bottomRows(ball.triangles.rows()) =
      ball.triangles.array() + static_cast<std::int32_t>(ball.points.rows());
  EXPECT_THROW(tubeAxis(two, 0, static_cast<int>(ball.points.rows())), DataError);
}

} // namespace
} // namespace viscera::geometry
