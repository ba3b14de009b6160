#include "viscera/geometry/decimate_surface.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/geometry/split_edges.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::geometry {
namespace {

/// A torus around z: a closed surface with a tunnel.
TriangleMesh torus(double around, double radius, int steps) {
  TriangleMesh mesh;
  mesh.points.resize(steps * steps, 3);
  mesh.triangles.resize(2 * steps * steps, 3);
  const double step = 2 * std::numbers::pi / steps;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double r = around + radius * std::cos(j * step);
      mesh.points.row(i * steps + j) << r * std::cos(i * step), r * std::sin(i * step),
          radius * std::sin(j * step);
      const auto at = [&](int a, int b) { return (a % steps) * steps + b % steps; };
      mesh.triangles.row(2 * (i * steps + j)) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
      mesh.triangles.row(2 * (i * steps + j) + 1) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
    }
  return mesh;
}

int eulerCharacteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.points.rows() - mesh.triangles.rows() / 2);
}

void expectSound(const TriangleMesh& mesh) {
  const SurfaceReport report = checkSurface(mesh);
  EXPECT_TRUE(report.outward());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.unusedVertices, 0);
  EXPECT_EQ(report.degenerateTriangles, 0);
}

TEST(DecimateClosedSurface, KeepsASphereRound) {
  const TriangleMesh fine = tests::sphere(5, 50, {300, -200, 1000});
  const TriangleMesh thin = decimateClosedSurface(fine, 1000);
  expectSound(thin);
  EXPECT_LE(thin.triangles.rows(), 1000);
  EXPECT_GE(thin.triangles.rows(), 998);
  for (Eigen::Index v = 0; v < thin.points.rows(); ++v)
    EXPECT_NEAR((thin.points.row(v).transpose() - Vec3(300, -200, 1000)).norm(), 50, 0.25);
}

/// Flat faces cost nothing, edges and corners do.
TEST(DecimateClosedSurface, KeepsTheEdgesOfABox) {
  const TriangleMesh fine = splitLongEdges(tests::box(30, 40, 50), 3, 100'000);
  ASSERT_GT(fine.triangles.rows(), 3000);
  const TriangleMesh thin = decimateClosedSurface(fine, 300);
  expectSound(thin);
  EXPECT_LE(thin.triangles.rows(), 300);
  EXPECT_NEAR(checkSurface(thin).volumeMm3, 60000, 60);
  const Bounds box = boundsOf(thin.points);
  EXPECT_NEAR(box.diagonal(), Vec3(30, 40, 50).norm(), 0.1);
}

TEST(DecimateClosedSurface, StopsAtATetrahedron) {
  const TriangleMesh thin = decimateClosedSurface(tests::sphere(3, 10), 0);
  EXPECT_EQ(thin.triangles.rows(), 4);
  expectSound(thin);
}

TEST(DecimateClosedSurface, KeepsTunnels) {
  const TriangleMesh fine = torus(40, 12, 96);
  ASSERT_EQ(eulerCharacteristic(fine), 0);
  for (const int triangles : {4000, 400, 60, 10}) {
    SCOPED_TRACE(triangles);
    const TriangleMesh thin = decimateClosedSurface(fine, triangles);
    expectSound(thin);
    EXPECT_EQ(eulerCharacteristic(thin), 0) << "the tunnel is gone";
  }
}

TEST(DecimateClosedSurface, KeepsPieces) {
  TriangleMesh two = tests::sphere(4, 20);
  const TriangleMesh other = tests::sphere(4, 5, {40, 0, 0});
  const Eigen::Index points = two.points.rows(), triangles = two.triangles.rows();
  two.points.conservativeResize(points + other.points.rows(), 3);
  two.points.bottomRows(other.points.rows()) = other.points;
  two.triangles.conservativeResize(triangles + other.triangles.rows(), 3);
  two.triangles.bottomRows(other.triangles.rows()) =
      other.triangles.array() + static_cast<std::int32_t>(points);
  const TriangleMesh thin = decimateClosedSurface(two, 300);
  expectSound(thin);
  EXPECT_EQ(checkSurface(thin).components, 2);
}

TEST(DecimateClosedSurface, LeavesWhatIsCoarseEnough) {
  const TriangleMesh mesh = tests::sphere(2, 10);
  const TriangleMesh same = decimateClosedSurface(mesh, 128);
  EXPECT_EQ(same.points, mesh.points);
  EXPECT_EQ(same.triangles, mesh.triangles);
}

} // namespace
} // namespace viscera::geometry
