#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "mesh_checks.h"
#include "viscera/anatomy/part.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/assess_patient.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {
namespace {

using test::warnsOf;

const std::filesystem::path kOrgans = VISCERA_SHARED_ORGANS;

#define SKIP_WITHOUT(file)                                                                                   \
  if (!std::filesystem::exists(file))                                                                        \
  GTEST_SKIP() << (file).filename() << " is not there; it is not part of the project"

TEST(SharedOrgans, LiverOfTriangleStripsIsClosedAndManifold) {
  const auto file = kOrgans / "liver.vtk";
  SKIP_WITHOUT(file);
  const SurfaceFile liver = readSurface(file);
  const geometry::SurfaceReport report = geometry::checkSurface(liver.mesh);
  // 33,950 points in the file, some of them twice: without merging the surface would have slits.
  EXPECT_EQ(liver.mesh.points.rows(), 33568);
  EXPECT_TRUE(warnsOf(liver, "382 points that repeat another merged"));
  EXPECT_EQ(report.boundaryEdges, 0);
  EXPECT_EQ(report.nonManifoldEdges, 0);
  EXPECT_EQ(report.misorientedEdges, 0);
  EXPECT_EQ(report.degenerateTriangles, 0);
  // Euler: a closed manifold in one piece has an even characteristic of 2 or less; here n - 3/2 m + m.
  const Eigen::Index characteristic = liver.mesh.points.rows() - liver.mesh.triangles.rows() / 2;
  EXPECT_EQ(report.components, 1);
  EXPECT_LE(characteristic, 2);
  EXPECT_EQ(characteristic % 2, 0);
  EXPECT_FALSE(liver.spaceStated);
  EXPECT_EQ(liver.name, "liver");
}

TEST(SharedOrgans, LiverOf238MillilitresIsQuestioned) {
  const auto file = kOrgans / "liver.vtk";
  SKIP_WITHOUT(file);
  const SurfaceFile liver = readSurface(file);
  EXPECT_NEAR(std::abs(geometry::checkSurface(liver.mesh).volumeMm3) / kMm3PerMl, 238, 1);
  EXPECT_TRUE(warnsOf(liver, "not life-sized"));
}

TEST(SharedOrgans, LeftKidneyOfTriangleStripsIsClosedAndManifold) {
  const auto file = kOrgans / "kidney_left.vtk";
  SKIP_WITHOUT(file);
  const SurfaceFile kidney = readSurface(file);
  const geometry::SurfaceReport report = geometry::checkSurface(kidney.mesh);
  EXPECT_EQ(kidney.mesh.points.rows(), 9968 - 69) << "69 points are in the file twice";
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(kidney.mesh.triangles.rows(), 2 * kidney.mesh.points.rows() - 4)
      << "a kidney is a ball to topology";
}

TEST(SharedOrgans, BunnyKeepsItsUsedVerticesAndItsHoles) {
  const auto file = kOrgans / "bunny.obj";
  SKIP_WITHOUT(file);
  const SurfaceFile bunny = readSurface(file);
  // Of its 35,947 points 1,113 belong to no triangle.
  EXPECT_EQ(bunny.mesh.points.rows(), 35947 - 1113);
  EXPECT_TRUE(warnsOf(bunny, "1113 points without a triangle dropped"));
  EXPECT_EQ(bunny.mesh.triangles.rows(), 69451);
  EXPECT_EQ(geometry::checkSurface(bunny.mesh).boundaryEdges, 223);
  EXPECT_TRUE(warnsOf(bunny, "boundary edges"));
  EXPECT_TRUE(warnsOf(bunny, "metres")) << "it is 0.25 units across";
}

/// The whole way: 95 labels of a CT atlas, among them a colon full of tunnels, vessels of a voxel and specks.
TEST(SharedOrgans, LabelsOfTheAbdomenAreClosedAndAsLargeAsTheirVoxels) {
  const auto file = kOrgans / "abdomen_seg.nrrd";
  SKIP_WITHOUT(file);
  const auto start = std::chrono::steady_clock::now();
  Progress progress;
  const LabelMap map = readLabelMap(file, progress);
  EXPECT_EQ(map.segments.size(), 95U);
  EXPECT_TRUE(map.spacing().isApprox(Vec3(0.9375, 0.9375, 1.5), 1e-9));
  const std::vector<LabelSurface> surfaces = labelSurfaces(map, {}, progress);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::cout << surfaces.size() << " labels into surfaces: " << seconds.count() << " s\n";
  ASSERT_EQ(surfaces.size(), map.segments.size());
  Eigen::Index triangles = 0;
  for (const LabelSurface& surface : surfaces)
    triangles += surface.mesh.triangles.rows();
  EXPECT_NEAR(static_cast<double>(triangles), 884000, 500)
      << "the figure of README.md and docs/performance.md";
  for (const LabelSurface& surface : surfaces) {
    SCOPED_TRACE(map.segments[surface.segment].name);
    const geometry::SurfaceReport report = geometry::checkSurface(surface.mesh);
    EXPECT_TRUE(report.outward());
    EXPECT_TRUE(report.manifold());
    EXPECT_NEAR(report.volumeMm3, surface.voxelVolumeMm3, 0.01 * surface.voxelVolumeMm3);
    EXPECT_DOUBLE_EQ(surface.voxelVolumeMm3,
                     static_cast<double>(map.segments[surface.segment].voxels) * map.voxelVolumeMm3());
    EXPECT_LE(surface.mesh.triangles.rows(), 40000);
  }
}

PlacedOrgan inOtherAxes(PlacedOrgan organ, double x, double y) {
  const Vec3 signs(x, y, 1), a = signs.cwiseProduct(organ.bounds.low),
                             b = signs.cwiseProduct(organ.bounds.high);
  organ.bounds = {a.cwiseMin(b), a.cwiseMax(b)};
  return organ;
}

/// 41 organs of a CT, and the atlas: also with any one of them left out.
TEST(SharedOrgans, AllOrgansOfAPatientAreNamedAndToldFromThoseInRasAndMirrored) {
  for (const char* name : {"ct/example_seg.nii.gz", "abdomen_seg.nrrd"}) {
    const auto file = kOrgans / name;
    SKIP_WITHOUT(file);
    SCOPED_TRACE(name);
    Progress progress;
    const LabelMap map = readLabelMap(file, progress);
    if (map.segments.size() == 41)
      for (const Segment& segment : map.segments) {
        const auto part = anatomy::partNamed(segment.name);
        ASSERT_TRUE(part) << segment.name;
        const bool left = segment.name.find("left") != std::string::npos;
        const bool right = segment.name.find("right") != std::string::npos;
        EXPECT_EQ(part->side, left    ? anatomy::Side::left
                              : right ? anatomy::Side::right
                                      : anatomy::Side::none)
            << segment.name;
      }
    const std::vector<PlacedOrgan> patient = placedOrgans(map);
    for (std::size_t without = 0; without <= patient.size(); ++without) {
      std::vector<PlacedOrgan> lps, ras, mirrored;
      for (std::size_t i = 0; i < patient.size(); ++i)
        if (i != without) {
          lps.push_back(patient[i]);
          ras.push_back(inOtherAxes(patient[i], -1, -1));
          mirrored.push_back(inOtherAxes(patient[i], -1, 1));
        }
      EXPECT_EQ(assessPatient(lps).axes(), "LPS") << without;
      EXPECT_EQ(assessPatient(ras).axes(), "RAS") << without;
      EXPECT_EQ(assessPatient(mirrored).axes(), "mirrored") << without;
      EXPECT_FALSE(assessPatient(ras).sidesChecked() || assessPatient(mirrored).sidesChecked()) << without;
      EXPECT_FALSE(assessPatient(ras).findings.empty() || assessPatient(mirrored).findings.empty())
          << without;
    }
  }
}

TEST(SharedOrgans, LiverOfTheLabelMapIsWhereTheAtlasHasIt) {
  const auto file = kOrgans / "abdomen_seg.nrrd";
  SKIP_WITHOUT(file);
  Progress progress;
  const LabelMap map = readLabelMap(file, progress);
  const auto liver = segmentsNamed(map, {"Liver"}, "atlas");
  ASSERT_EQ(liver.size(), 1U);
  const auto surfaces = labelSurfaces(map, {.segments = liver}, progress);
  auto mesh = std::make_shared<geometry::TriangleMesh>(surfaces.at(0).mesh);
  const geometry::SignedDistance distance(mesh);
  geometry::TriangleMesh atlas = readSurface(kOrgans / "liver.vtk").mesh;
  atlas.points.leftCols<2>() *= -1; // It is in RAS and does not say so.
  double sum = 0;
  for (Eigen::Index v = 0; v < atlas.points.rows(); ++v)
    sum += std::abs(distance(atlas.points.row(v).transpose()));
  const double mean = sum / static_cast<double>(atlas.points.rows());
  std::cout << "mean distance from the atlas's liver: " << mean << " mm\n";
  EXPECT_LT(mean, 1.5 * map.spacing().minCoeff());
  EXPECT_TRUE(std::any_of(surfaces[0].warnings.begin(), surfaces[0].warnings.end(), [](const Text& warning) {
    return warning.english().find("not life-sized") != std::string::npos;
  }));
}

} // namespace
} // namespace viscera::medical_io
