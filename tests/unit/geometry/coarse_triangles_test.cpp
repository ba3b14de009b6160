#include "viscera/geometry/coarse_triangles.h"

#include <set>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

std::size_t verticesOf(const Triangles& triangles) {
  return std::set<std::int32_t>(triangles.data(), triangles.data() + triangles.size()).size();
}

TEST(CoarseTriangles, HaveAboutAsManyVerticesAsAreAskedFor) {
  const TriangleMesh ball = tests::sphere(6, 60);
  for (const Eigen::Index wanted : {500, 2000, 8000}) {
    const std::size_t vertices = verticesOf(coarseTriangles(ball, wanted));
    EXPECT_GT(vertices, 0.6 * double(wanted));
    EXPECT_LT(vertices, 1.5 * double(wanted));
  }
}

TEST(CoarseTriangles, StandForTheSurfaceInItsPoseToo) {
  TriangleMesh ball = tests::sphere(6, 60);
  const Triangles coarse = coarseTriangles(ball, 2000);
  EXPECT_NEAR(volume(ball.points, coarse) / volume(ball.points, ball.triangles), 1, 0.03);
  for (auto point : ball.points.rowwise())
    point *= 1 + 0.003 * point[2];
  EXPECT_NEAR(volume(ball.points, coarse) / volume(ball.points, ball.triangles), 1, 0.03);
}

TEST(CoarseTriangles, OfASmallSurfaceAreAllOfThem) {
  const TriangleMesh ball = tests::sphere(3, 60);
  EXPECT_EQ(coarseTriangles(ball, ball.points.rows()), ball.triangles);
  EXPECT_THROW(coarseTriangles(ball, 3), UsageError);
}

TEST(CoarseTriangles, OfASurfaceWithoutAreaAreItsOwn) {
  TriangleMesh flat = tests::sphere(3, 60);
  flat.points.setZero();
  EXPECT_EQ(coarseTriangles(flat, 10), flat.triangles);
}

} // namespace
} // namespace viscera::geometry
