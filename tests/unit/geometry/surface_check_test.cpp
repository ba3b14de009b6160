#include "viscera/geometry/surface_check.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

TriangleMesh without(const TriangleMesh& mesh, Eigen::Index triangle) {
  TriangleMesh open = mesh;
  open.triangles.row(triangle) = mesh.triangles.row(mesh.triangles.rows() - 1);
  open.triangles.conservativeResize(mesh.triangles.rows() - 1, 3);
  return open;
}

TEST(CheckSurface, FindsNothingWrongWithASphere) {
  const auto report = checkSurface(tests::sphere(3));
  EXPECT_TRUE(report.closed() && report.manifold() && report.outward());
  EXPECT_EQ(report.components, 1);
  EXPECT_THAT(inEnglish(faults(report)), testing::IsEmpty());
}

TEST(CheckSurface, CountsTheEdgesOfAHole) {
  const auto report = checkSurface(without(tests::sphere(3), 17));
  EXPECT_EQ(report.boundaryEdges, 3);
  EXPECT_FALSE(report.outward());
  EXPECT_THAT(inEnglish(faults(report)), testing::ElementsAre(testing::HasSubstr("3 boundary edges")));
}

TEST(CheckSurface, CountsEdgesOfThreeTriangles) {
  auto mesh = tests::box();
  mesh.points.conservativeResize(9, 3);
  mesh.points.row(8) << 2, 2, 2;
  mesh.triangles.conservativeResize(13, 3);
  mesh.triangles.row(12) << 0, 1, 8;
  const auto report = checkSurface(mesh);
  EXPECT_EQ(report.nonManifoldEdges, 1);
  EXPECT_EQ(report.boundaryEdges, 2);
}

TEST(CheckSurface, CountsEdgesOfAFlippedTriangle) {
  auto mesh = tests::sphere(2);
  std::swap(mesh.triangles(5, 0), mesh.triangles(5, 1));
  const auto report = checkSurface(mesh);
  EXPECT_EQ(report.misorientedEdges, 3);
  EXPECT_FALSE(report.manifold());
}

TEST(CheckSurface, CountsPiecesUnusedVerticesAndTrianglesWithoutArea) {
  auto mesh = tests::box();
  const auto other = tests::box();
  mesh.points.conservativeResize(18, 3);
  mesh.points.middleRows(8, 8) = other.points.array() + 5;
  mesh.points.row(16) << 9, 9, 9;
  mesh.points.row(17) = mesh.points.row(16);
  mesh.triangles.conservativeResize(25, 3);
  mesh.triangles.middleRows(12, 12) = other.triangles.array() + 8;
  mesh.triangles.row(24) << 0, 0, 1;
  const auto report = checkSurface(mesh);
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(report.unusedVertices, 2);
  EXPECT_EQ(report.degenerateTriangles, 1);
}

TEST(OrientOutward, TurnsASurfaceThatIsInsideOut) {
  auto mesh = tests::sphere(2);
  EXPECT_FALSE(orientOutward(mesh));
  mesh.triangles.col(0).swap(mesh.triangles.col(1));
  EXPECT_THAT(inEnglish(faults(checkSurface(mesh))), testing::ElementsAre(testing::HasSubstr("inside out")));
  EXPECT_TRUE(orientOutward(mesh));
  EXPECT_TRUE(checkSurface(mesh).outward());
}

TEST(RequireValid, NamesTheVertexThatIsNotFinite) {
  auto mesh = tests::box();
  mesh.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  try {
    requireValid(mesh, "box.stl");
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("box.stl: Vertex 3"));
  }
}

TEST(RequireValid, NamesTheTriangleThatLeavesTheMesh) {
  auto mesh = tests::box();
  mesh.triangles(4, 2) = 8;
  EXPECT_THROW(requireValid(mesh, "box"), DataError);
  mesh.triangles(4, 2) = -1;
  EXPECT_THROW(requireValid(mesh, "box"), DataError);
}

} // namespace
} // namespace viscera::geometry
