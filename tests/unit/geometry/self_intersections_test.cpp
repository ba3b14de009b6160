#include "viscera/geometry/self_intersections.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "self_intersections.h"
#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

int count(const TriangleMesh& mesh, int threads = 0) {
  Progress progress;
  return countSelfIntersections(mesh, progress, Threads{threads});
}

TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both;
  both.points.resize(a.points.rows() + b.points.rows(), 3);
  both.points << a.points, b.points;
  both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  both.triangles << a.triangles, b.triangles.array() + static_cast<std::int32_t>(a.points.rows());
  return both;
}

/// Every point pushed along by a pseudo-random vector: neighbours cross, share vertices, and fold over.
TriangleMesh crumpled(int levels, double by) {
  TriangleMesh mesh = tests::sphere(levels, 50);
  std::uint32_t state = 12345;
  for (double& coordinate : mesh.points.reshaped()) {
    state = state * 1664525U + 1013904223U;
    coordinate += by * (static_cast<double>(state >> 8U) / (1U << 24U) - 0.5);
  }
  return mesh;
}

TEST(SelfIntersections, ASphereAndABoxHaveNone) {
  EXPECT_EQ(count(tests::sphere(4, 50, {0.1, 0.2, 0.3})), 0);
  EXPECT_EQ(count(tests::box(3, 2, 1)), 0) << "its sides are flat, its triangles touch at edges and corners";
}

TEST(SelfIntersections, OfTwoSpheresThatOverlapAreThoseThatCgalFinds) {
  const TriangleMesh mesh = together(tests::sphere(3, 50), tests::sphere(3, 40, {45.3, 7.1, 2.2}));
  const int found = count(mesh);
  EXPECT_GT(found, 50);
  EXPECT_EQ(found, tests::selfIntersections(mesh));
}

TEST(SelfIntersections, OfCrumpledSurfacesAreThoseThatCgalFinds) {
  for (const double by : {5.0, 20.0, 60.0}) {
    const TriangleMesh mesh = crumpled(3, by);
    EXPECT_EQ(count(mesh), tests::selfIntersections(mesh)) << by;
  }
}

/// Turned, the corners of a flat grid come to lie in one plane only but for rounding: the planes of its
/// triangles cross everywhere, the triangles nowhere.
TEST(SelfIntersections, AFlatPlaceThatIsTurnedHasNone) {
  constexpr int kSide = 24;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  TriangleMesh mesh;
  mesh.points.resize(kSide * kSide, 3);
  mesh.triangles.resize(2 * (kSide - 1) * (kSide - 1), 3);
  Eigen::Index triangle = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const int at = kSide * i + j;
      mesh.points.row(at) = turn * Vec3(1.3 * i, 1.1 * j + 0.1 * i, 70);
      if (i + 1 < kSide && j + 1 < kSide) {
        mesh.triangles.row(triangle++) << at, at + kSide, at + 1;
        mesh.triangles.row(triangle++) << at + 1, at + kSide, at + kSide + 1;
      }
    }
  EXPECT_EQ(count(mesh), 0);
  EXPECT_EQ(count(mesh), tests::selfIntersections(mesh));
}

TEST(SelfIntersections, BoxesThatLieOnEachOtherTouch) {
  TriangleMesh upper = tests::box(1, 1, 1);
  upper.points.rowwise() += Eigen::RowVector3d(0.25, 0.25, 1);
  const TriangleMesh mesh = together(tests::box(1, 1, 1), upper);
  EXPECT_EQ(count(mesh), tests::selfIntersections(mesh)) << "coplanar triangles that overlap";
}

TEST(SelfIntersections, ATriangleFoldedOntoItsNeighbourCounts) {
  TriangleMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points << 0, 0, 0, 10, 0, 0, 5, 8, 0, 5, 3, 0;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 1, 0, 3;
  EXPECT_EQ(count(mesh), 1);
  mesh.points(3, 1) = -3;
  EXPECT_EQ(count(mesh), 0) << "flat beside each other";
}

TEST(SelfIntersections, DoNotDependOnTheNumberOfThreads) {
  const TriangleMesh mesh = crumpled(4, 20);
  EXPECT_EQ(count(mesh, 1), count(mesh, 5));
}

TEST(SelfIntersections, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(countSelfIntersections(tests::sphere(3), progress), Cancelled);
}

} // namespace
} // namespace viscera::geometry
