#include "viscera/medical_io/surface_repairs.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::medical_io {
namespace {

geometry::TriangleMesh openSphere() {
  geometry::TriangleMesh mesh = tests::sphere(4, 30, {1, 2, 3});
  mesh.triangles = mesh.triangles.bottomRows(mesh.triangles.rows() - 60).eval();
  return mesh;
}

TEST(RepairSurface, ClosesHolesNearTheSurface) {
  Progress progress;
  const auto repaired = repairSurface(openSphere(), {.cells = 40, .triangles = 3000}, progress);
  const auto report = geometry::checkSurface(repaired);
  EXPECT_TRUE(report.outward());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.components, 1);
  EXPECT_NEAR(report.volumeMm3, 4.0 / 3 * M_PI * 27'000, 0.03 * 4.0 / 3 * M_PI * 27'000);
  EXPECT_NEAR(static_cast<double>(repaired.triangles.rows()), 3000, 30);
  const Values radii = (repaired.points.rowwise() - Eigen::RowVector3d(1, 2, 3)).rowwise().norm();
  EXPECT_LT(radii.maxCoeff(), 30.5);
}

/// Flat faces with sharp edges, whose quadrics say nothing about where in the face a vertex should be.
TEST(RepairSurface, KeepsTheFlatFacesOfACubeFromFolding) {
  for (const int triangles : {800, 5000}) {
    Progress progress;
    const auto repaired =
        repairSurface(tests::box(20, 20, 20), {.cells = 60, .triangles = triangles}, progress);
    const auto report = geometry::checkSurface(repaired);
    EXPECT_TRUE(report.outward());
    EXPECT_EQ(geometry::countSelfIntersections(repaired, progress), 0) << triangles;
    EXPECT_NEAR(static_cast<double>(repaired.triangles.rows()), triangles, 2);
    EXPECT_NEAR(report.volumeMm3, 8000, 0.02 * 8000);
  }
}

TEST(RepairSurface, DropsCrumbsAndKeepsPieces) {
  geometry::TriangleMesh mesh = tests::sphere(4, 30);
  for (const auto& other : {tests::sphere(3, 15, {60, 0, 0}), tests::sphere(2, 3, {0, 45, 0})}) {
    const auto points = mesh.points.rows(), triangles = mesh.triangles.rows();
    mesh.points.conservativeResize(points + other.points.rows(), 3);
    mesh.points.bottomRows(other.points.rows()) = other.points;
    mesh.triangles.conservativeResize(triangles + other.triangles.rows(), 3);
    mesh.triangles.bottomRows(other.triangles.rows()) =
        other.triangles.array() + static_cast<std::int32_t>(points);
  }
  Progress progress;
  const auto repaired = repairSurface(mesh, {.cells = 60, .triangles = 5000}, progress);
  EXPECT_EQ(geometry::checkSurface(repaired).components, 2);
}

TEST(RepairSurface, IsTheSameForAnyNumberOfThreads) {
  Progress progress;
  const auto one = repairSurface(openSphere(), {.cells = 30, .triangles = 1000}, progress, {1});
  const auto three = repairSurface(openSphere(), {.cells = 30, .triangles = 1000}, progress, {3});
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
}

TEST(RepairSurface, RefusesWhatEnclosesNothing) {
  Progress progress;
  EXPECT_THROW(repairSurface({}, {}, progress), DataError);
  geometry::TriangleMesh lid = tests::sphere(3, 30);
  lid.triangles = lid.triangles.topRows(4).eval();
  EXPECT_THROW(repairSurface(lid, {.cells = 30}, progress), DataError);
  progress.cancel();
  EXPECT_THROW(repairSurface(openSphere(), {.cells = 30}, progress), Cancelled);
}

TEST(SurfaceRepairs, StandAModelUpWhoseYAxisPointsToTheHead) {
  Progress progress;
  // Tall along y, its face at +z, its left at +x.
  const auto model = tests::box(20, 60, 30);
  const auto turned = surfaceRepair("y-up").apply(model, progress, {});
  const Bounds before = boundsOf(model.points), after = boundsOf(turned.points);
  EXPECT_EQ(after.low.x(), before.low.x());
  EXPECT_EQ(after.high.z(), before.high.y()) << "the head is superior";
  EXPECT_EQ(after.low.y(), -before.high.z()) << "the face is anterior";
  EXPECT_NEAR(geometry::checkSurface(turned).volumeMm3, 20 * 60 * 30, 1e-6) << "turned, not mirrored";
}

TEST(ThinSurface, KeepsASurfaceClosedAndItsVolume) {
  const auto thin = thinSurface(tests::sphere(5, 30), 1500);
  const auto report = geometry::checkSurface(thin);
  EXPECT_TRUE(report.outward());
  EXPECT_LE(thin.triangles.rows(), 1510);
  EXPECT_NEAR(report.volumeMm3, 4.0 / 3 * M_PI * 27'000, 0.01 * 4.0 / 3 * M_PI * 27'000);
  const auto coarse = tests::sphere(2, 30);
  EXPECT_EQ(thinSurface(coarse, 1500).triangles, coarse.triangles);
}

} // namespace
} // namespace viscera::medical_io
