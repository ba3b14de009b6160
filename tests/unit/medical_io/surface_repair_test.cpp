#include "viscera/medical_io/surface_repairs.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_pieces.h"

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

geometry::TriangleMesh joined(const std::vector<geometry::TriangleMesh>& parts) {
  geometry::TriangleMesh all = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto points = all.points.rows(), triangles = all.triangles.rows();
    all.points.conservativeResize(points + parts[i].points.rows(), 3);
    all.points.bottomRows(parts[i].points.rows()) = parts[i].points;
    all.triangles.conservativeResize(triangles + parts[i].triangles.rows(), 3);
    all.triangles.bottomRows(parts[i].triangles.rows()) =
        parts[i].triangles.array() + static_cast<std::int32_t>(points);
  }
  return all;
}

/// Twelve ribs, of which the smallest has a third of the largest, and three crumbs.
geometry::TriangleMesh ribs() {
  std::vector<geometry::TriangleMesh> parts;
  for (int rib = 0; rib < 12; ++rib)
    parts.push_back(tests::sphere(2, 15 + 1.5 * rib, {0, 0, 100.0 * rib}));
  for (int crumb = 0; crumb < 3; ++crumb)
    parts.push_back(tests::sphere(1, 2, {80, 0, 100.0 * crumb}));
  return joined(parts);
}

TEST(RemoveFragments, KeepsEveryRibAndDropsTheCrumbs) {
  Progress progress;
  const auto mesh = ribs();
  for (const char* id :
       {"remove-fragments", "remove-fragments=1%", "remove-fragments=6mm", "remove-fragments=0.5ml"}) {
    const auto mended = surfaceRepair(id).apply(mesh, progress, {});
    EXPECT_EQ(geometry::checkSurface(mended).components, 12) << id;
    EXPECT_EQ(mended.points.rows(), 12 * tests::sphere(2, 1).points.rows()) << "no loose vertices: " << id;
  }
  EXPECT_EQ(
      geometry::checkSurface(surfaceRepair("remove-fragments=1000mm").apply(mesh, progress, {})).components,
      1)
      << "the largest always stays";
}

TEST(RemoveFragments, SaysBeforehandWhatGoes) {
  const auto mesh = ribs();
  const SurfacePieces pieces(mesh);
  const FragmentLimit limit = fragmentLimit("10mm").value();
  EXPECT_EQ(pieces.fragments(limit), 3U);
  EXPECT_EQ(pieces.part(limit, true).triangles.rows() + pieces.part(limit, false).triangles.rows(),
            mesh.triangles.rows());
  EXPECT_EQ(describeFragments(pieces, limit).english().find("3 of 15 pieces go, of 4 mm"), 0U)
      << describeFragments(pieces, limit);
  EXPECT_EQ(describeFragments(pieces, fragmentLimit("0%").value()).english(),
            "none of the 15 pieces is as small as that");
  for (const char* words : {"", "5", "mm", "-1mm", "nan%", "5 mm", "5km"})
    EXPECT_FALSE(fragmentLimit(words)) << words;
  EXPECT_EQ(inWords(fragmentLimit("0.5ml").value()), "0.5ml");
}

/// A heart's coronary vessel, thinner than the cells of the usual grid.
TEST(Remesh, SaysThatItLostAVesselAndKeepsItAtAFinerResolution) {
  Progress progress;
  geometry::TriangleMesh vessel = tests::sphere(3, 1.3);
  vessel.points.col(0) += 12.7 * vessel.points.col(0).cwiseSign(); // A rod with round ends.
  vessel.points.rowwise() += Eigen::RowVector3d(52, 0, 0);
  const auto mesh = joined({tests::sphere(4, 40), vessel});
  const auto coarse = surfaceRepair("remesh").apply(mesh, progress, {});
  const auto lost = doubtAbout(surfaceChange(mesh, coarse));
  ASSERT_TRUE(lost);
  EXPECT_NE(lost->english().find("26 mm"), std::string::npos) << *lost;
  const auto fine = surfaceRepair("remesh=0.6").apply(mesh, progress, {});
  EXPECT_FALSE(doubtAbout(surfaceChange(mesh, fine)));
  EXPECT_GT(fine.triangles.rows(), coarse.triangles.rows());
  EXPECT_NEAR(static_cast<double>(fine.triangles.rows()), trianglesAt(mesh, 0.6),
              0.05 * trianglesAt(mesh, 0.6));
  EXPECT_THROW(surfaceRepair("remesh=0.02").apply(mesh, progress, {}), DataError) << "no memory for that";
  EXPECT_THROW(surfaceRepair("remesh=fine"), UsageError);
}

TEST(Scale, LeadsAStomachOfMetresToLifeSize) {
  Progress progress;
  const auto stomach = tests::sphere(4, 1350); // 2.7 m, which no unit explains.
  const double volumeMl = geometry::checkSurface(stomach).volumeMm3 / kMm3PerMl;
  const double factor = lifeSizeFactor("stomach", volumeMl).value();
  const auto scaled = surfaceRepair("scale=" + std::to_string(factor)).apply(stomach, progress, {});
  const double scaledMl = geometry::checkSurface(scaled).volumeMm3 / kMm3PerMl;
  EXPECT_FALSE(doubtAboutVolume("stomach", scaledMl));
  EXPECT_NEAR(lifeSizeFactor("stomach", scaledMl).value(), 1, 1e-3);
  EXPECT_NEAR(lifeSizeFactor("liver", 1360).value(), 1, 1e-3) << "the middle of 814 to 1906 ml";
  EXPECT_FALSE(lifeSizeFactor("thing", 100));
  EXPECT_FALSE(lifeSizeFactor("liver", 0));
  for (const char* id : {"scale", "scale=", "scale=0", "scale=-1", "scale=1mm", "mirror=2"})
    EXPECT_THROW(surfaceRepair(id), UsageError) << id;
}

} // namespace
} // namespace viscera::medical_io
