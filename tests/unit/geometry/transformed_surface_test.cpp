#include "viscera/geometry/triangle_mesh.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::geometry {
namespace {

TEST(TransformedSurface, AMirroredOneFacesOutwardAndTwiceIsTheSame) {
  const TriangleMesh mesh = tests::tetrahedron(3, 2, 1);
  const TriangleMesh other = mirrored(mesh);
  EXPECT_EQ(other.points.row(1), Eigen::RowVector3d(-3, 0, 0));
  EXPECT_DOUBLE_EQ(checkSurface(other).volumeMm3, 1);
  EXPECT_EQ(mirrored(other).points, mesh.points);
  EXPECT_EQ(mirrored(other).triangles, mesh.triangles);
}

TEST(TransformedSurface, HalfATurnMirrorsNothing) {
  const TriangleMesh other = turnedHalf(tests::tetrahedron(3, 2, 1));
  EXPECT_EQ(other.points.row(1), Eigen::RowVector3d(-3, 0, 0));
  EXPECT_EQ(other.points.row(2), Eigen::RowVector3d(0, -2, 0));
  EXPECT_EQ(other.points.row(3), Eigen::RowVector3d(0, 0, 1));
  EXPECT_EQ(other.triangles, tests::tetrahedron().triangles);
}

TEST(TransformedSurface, MetresBecomeMillimetres) {
  EXPECT_DOUBLE_EQ(checkSurface(scaled(tests::box(0.1, 0.2, 0.3), 1000)).volumeMm3, 100.0 * 200 * 300);
}

TEST(FaceOutward, TurnsSingleTrianglesAndWholeSurfaces) {
  TriangleMesh mesh = tests::sphere(2, 50);
  EXPECT_EQ(faceOutward(mesh), 0);
  mesh.triangles.col(0).swap(mesh.triangles.col(1));
  std::swap(mesh.triangles(5, 0), mesh.triangles(5, 1));
  EXPECT_EQ(faceOutward(mesh), mesh.triangles.rows() - 1);
  EXPECT_TRUE(checkSurface(mesh).outward());
  EXPECT_TRUE(checkSurface(mesh).manifold());
}

TEST(FaceOutward, TurnsAnOpenSurfaceFarFromTheOrigin) {
  TriangleMesh mesh = tests::sphere(3, 50, {900, -700, 300});
  mesh.triangles = mesh.triangles.topRows(mesh.triangles.rows() - 20).eval();
  const Triangles outward = mesh.triangles;
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  EXPECT_EQ(faceOutward(mesh), mesh.triangles.rows());
  EXPECT_EQ(mesh.triangles, outward);
}

TEST(LargestPiece, IsKeptWithItsColoursAndItsOrder) {
  const TriangleMesh large = tests::sphere(2, 50), crumb = tests::tetrahedron(5, 5, 5);
  TriangleMesh mesh;
  mesh.points.resize(large.points.rows() + 4, 3);
  mesh.points << crumb.points, large.points;
  mesh.triangles.resize(large.triangles.rows() + 4, 3);
  mesh.triangles << crumb.triangles, large.triangles.array() + 4;
  mesh.colors = mesh.points.cwiseAbs().cast<std::uint8_t>();
  const TriangleMesh kept = largestPiece(mesh);
  EXPECT_EQ(kept.points, large.points);
  EXPECT_EQ(kept.triangles, large.triangles);
  EXPECT_EQ(kept.colors, mesh.colors.bottomRows(large.points.rows()));
}

} // namespace
} // namespace viscera::geometry
