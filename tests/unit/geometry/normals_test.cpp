#include "viscera/geometry/normals.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace viscera::geometry {
namespace {

TEST(VertexNormals, OfASpherePointOutward) {
  const auto mesh = tests::sphere(4, 3, {1, 2, 3});
  const Normals normals = vertexNormals(mesh);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    const Vec3 outward = (mesh.points.row(v).transpose() - Vec3(1, 2, 3)).normalized();
    EXPECT_GT(normals.row(v).cast<double>().dot(outward.transpose()), 0.999);
    EXPECT_NEAR(normals.row(v).norm(), 1, 1e-5);
  }
}

TEST(VertexNormals, AreZeroWhereNoTriangleHasAnArea) {
  TriangleMesh mesh = tests::box();
  mesh.points.conservativeResize(9, 3);
  mesh.points.row(8) << 7, 7, 7;
  EXPECT_EQ(vertexNormals(mesh).row(8).norm(), 0);
}

TEST(VertexNormals, AreTheSameToTheBitForAnyNumberOfThreads) {
  const auto mesh = tests::sphere(6, 50);
  const auto around = vertexTriangles(mesh.points.rows(), mesh.triangles);
  Normals one, three;
  vertexNormals(mesh.points, mesh.triangles, around, one, {1});
  vertexNormals(mesh.points, mesh.triangles, around, three, {3});
  EXPECT_EQ(one, three);
}

TEST(VertexTriangles, ListsEveryCornerOnceInAscendingOrder) {
  const auto mesh = tests::box();
  const auto around = vertexTriangles(8, mesh.triangles);
  ASSERT_EQ(around.items.size(), 36u);
  for (int v = 0; v < 8; ++v)
    for (auto i = around.first[std::size_t(v)]; i < around.first[std::size_t(v) + 1]; ++i) {
      const auto t = around.items[std::size_t(i)];
      EXPECT_TRUE((mesh.triangles.row(t).array() == v).any());
      if (i > around.first[std::size_t(v)]) {
        EXPECT_LT(around.items[std::size_t(i) - 1], t);
      }
    }
}

} // namespace
} // namespace viscera::geometry
