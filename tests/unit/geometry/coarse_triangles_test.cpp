#include "viscera/geometry/coarse_triangles.h"

#include <random>
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

/// The normals of a rough plane lie in eight octants, whose clusters once lay across one another.
TEST(CoarseTriangles, DoNotFoldOnAFlatSide) {
  constexpr int kSide = 100;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> rough(-0.05, 0.05);
  TriangleMesh plane;
  plane.points.resize(kSide * kSide, 3);
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      plane.points.row(row * kSide + column) << column, row, rough(random);
  plane.triangles.resize(2 * (kSide - 1) * (kSide - 1), 3);
  Eigen::Index t = 0;
  for (int row = 0; row + 1 < kSide; ++row)
    for (int column = 0; column + 1 < kSide; ++column) {
      const int at = row * kSide + column;
      plane.triangles.row(t++) << at, at + 1, at + kSide;
      plane.triangles.row(t++) << at + 1, at + kSide + 1, at + kSide;
    }
  const Triangles coarse = coarseTriangles(plane, 1000);
  ASSERT_GT(coarse.rows(), 1000);
  for (const auto& triangle : coarse.rowwise()) {
    const Vec3 a = plane.points.row(triangle[0]), b = plane.points.row(triangle[1]);
    const Vec3 c = plane.points.row(triangle[2]);
    EXPECT_GE((b - a).cross(c - a).z(), 0) << triangle;
  }
}

TEST(CoarseTriangles, KeepTheSidesOfAThinPartApart) {
  TriangleMesh sheet = tests::sphere(6, 60);
  sheet.points.col(2) *= 0.02;
  const Triangles coarse = coarseTriangles(sheet, 1000);
  EXPECT_NEAR(volume(sheet.points, coarse) / volume(sheet.points, sheet.triangles), 1, 0.1);
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
