#include "viscera/geometry/clean_surface.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/signed_distance_grid.h"
#include "viscera/geometry/split_edges.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/geometry/winding_number.h"

namespace viscera::geometry {
namespace {

TEST(CleanSurface, LeavesACleanSurfaceAsItIs) {
  const TriangleMesh mesh = tests::sphere(2, 10);
  const CleanedSurface cleaned = cleanSurface(mesh);
  EXPECT_FALSE(cleaned.changed());
  EXPECT_EQ(cleaned.mesh.points, mesh.points);
  EXPECT_EQ(cleaned.mesh.triangles, mesh.triangles);
}

TEST(CleanSurface, MergesPointsThatEveryTriangleHasForItself) {
  const TriangleMesh mesh = tests::sphere(2, 10, {100, 0, 0});
  TriangleMesh soup;
  soup.points.resize(3 * mesh.triangles.rows(), 3);
  soup.triangles.resize(mesh.triangles.rows(), 3);
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    soup.points.row(i) = mesh.points.row(mesh.triangles.data()[i]);
    soup.triangles.data()[i] = static_cast<std::int32_t>(i);
  }
  const CleanedSurface cleaned = cleanSurface(soup);
  EXPECT_EQ(cleaned.mesh.points.rows(), mesh.points.rows());
  EXPECT_EQ(cleaned.mergedPoints, soup.points.rows() - mesh.points.rows());
  EXPECT_TRUE(checkSurface(cleaned.mesh).outward());
}

TEST(CleanSurface, RemovesRepeatedAndZeroAreaTrianglesAndUnusedPoints) {
  TriangleMesh mesh = tests::box(3, 4, 5);
  mesh.points.conservativeResize(9, 3);
  mesh.points.row(8) << 1, 1, 1;
  mesh.triangles.conservativeResize(15, 3);
  mesh.triangles.row(12) << 3, 0, 2; // The first one again.
  mesh.triangles.row(13) << 1, 1, 5;
  mesh.triangles.row(14) << 0, 7, 0;
  const CleanedSurface cleaned = cleanSurface(mesh);
  EXPECT_EQ(cleaned.removedTriangles, 3);
  EXPECT_EQ(cleaned.mesh.points.rows(), 8);
  EXPECT_DOUBLE_EQ(volume(cleaned.mesh.points, cleaned.mesh.triangles), 60);
}

TEST(CleanSurface, TurnsPatchesAndInsideOutSurfaces) {
  TriangleMesh patch = tests::sphere(3, 10), all = patch;
  for (int t = 10; t < 60; ++t)
    std::swap(patch.triangles(t, 1), patch.triangles(t, 2));
  all.triangles.col(0).swap(all.triangles.col(1));
  EXPECT_EQ(cleanSurface(patch).turnedTriangles, 50);
  EXPECT_EQ(cleanSurface(all).turnedTriangles, all.triangles.rows());
  for (const TriangleMesh& mesh : {patch, all}) {
    const auto report = checkSurface(cleanSurface(mesh).mesh);
    EXPECT_TRUE(report.outward());
    EXPECT_TRUE(report.manifold());
  }
}

TEST(CleanSurface, KeepsCavitiesTurnedInward) {
  TriangleMesh shells = tests::sphere(2, 10);
  const TriangleMesh inner = tests::sphere(2, 5);
  const auto points = shells.points.rows(), triangles = shells.triangles.rows();
  shells.points.conservativeResize(2 * points, 3);
  shells.triangles.conservativeResize(2 * triangles, 3);
  shells.points.bottomRows(points) = inner.points;
  shells.triangles.bottomRows(triangles) = inner.triangles.array() + static_cast<std::int32_t>(points);
  shells.triangles.bottomRows(triangles).col(0).swap(shells.triangles.bottomRows(triangles).col(1));
  EXPECT_FALSE(cleanSurface(shells).changed());
}

TEST(ClusterVertices, KeepsTheWindingNumberAwayFromTheSurface) {
  const TriangleMesh fine = tests::sphere(5, 20);
  const TriangleMesh coarse = clusterVertices(fine, 3);
  EXPECT_LT(coarse.triangles.rows(), fine.triangles.rows() / 4);
  const WindingNumber winding(coarse);
  EXPECT_NEAR(winding({3, -4, 5}), 1, 0.02);
  EXPECT_NEAR(winding({18, 18, 0}), 0, 0.02);
}

TEST(SplitLongEdges, KeepsTheShapeAndTheOrderOfPoints) {
  const TriangleMesh box = tests::box(30, 4, 5);
  const TriangleMesh fine = splitLongEdges(box, 3, 100'000);
  EXPECT_EQ(fine.points.topRows(8), box.points);
  const auto report = checkSurface(fine);
  EXPECT_TRUE(report.outward() && report.manifold());
  EXPECT_EQ(report.degenerateTriangles, 0);
  EXPECT_NEAR(report.volumeMm3, 600, 1e-9);
  for (Eigen::Index t = 0; t < fine.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_LE(
          (fine.points.row(fine.triangles(t, k)) - fine.points.row(fine.triangles(t, (k + 1) % 3))).norm(),
          3);
  EXPECT_LE(splitLongEdges(box, 0.01, 5000).triangles.rows(), 5000);
  EXPECT_EQ(splitLongEdges(box, 100, 5000).triangles, box.triangles);
}

TEST(SignedDistanceGrid, HoldsDistancesNearTheSurfaceWithTheirSign) {
  Progress progress;
  const SignedDistanceGrid grid = signedDistanceGrid(tests::sphere(5, 20, {1, 2, 3}), 1.5, progress);
  std::size_t i = 0;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x, ++i) {
        const double exact = (grid.origin + grid.spacing * Vec3(x, y, z) - Vec3(1, 2, 3)).norm() - 20;
        EXPECT_NEAR(grid.values[i], std::clamp(exact, -kDistanceBand * 1.5, kDistanceBand * 1.5), 0.05);
      }
}

TEST(SignedDistanceGrid, IsTheSameForAnyNumberOfThreads) {
  Progress progress;
  SignedDistanceGrid one = signedDistanceGrid(tests::sphere(3, 20), 2, progress, {1});
  SignedDistanceGrid three = signedDistanceGrid(tests::sphere(3, 20), 2, progress, {3});
  EXPECT_EQ(one.values, three.values);
  smoothen(one, 2, {1});
  smoothen(three, 2, {3});
  EXPECT_EQ(one.values, three.values);
  progress.cancel();
  EXPECT_THROW(signedDistanceGrid(tests::sphere(3, 20), 2, progress), Cancelled);
}

} // namespace
} // namespace viscera::geometry
