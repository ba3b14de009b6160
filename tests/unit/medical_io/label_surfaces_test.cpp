#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"

namespace viscera::medical_io {
namespace {

using tests::LabelImage;

LabelMap mapOf(const LabelImage& image) {
  const tests::TemporaryFolder folder;
  Progress progress;
  return readLabelMap(folder.put("a.nrrd", tests::nrrdFile(image)), progress);
}

std::vector<LabelSurface> surfacesOf(const LabelMap& map, const LabelSurfaceOptions& options = {},
                                     Threads threads = {}) {
  Progress progress;
  return labelSurfaces(map, options, progress, threads);
}

void expectSound(const LabelSurface& surface) {
  const geometry::SurfaceReport report = geometry::checkSurface(surface.mesh);
  EXPECT_TRUE(report.closed()) << report.boundaryEdges;
  EXPECT_TRUE(report.manifold()) << report.nonManifoldEdges << " " << report.misorientedEdges;
  EXPECT_TRUE(report.outward());
  EXPECT_NEAR(report.volumeMm3, surface.voxelVolumeMm3, kVolumeTolerance * surface.voxelVolumeMm3);
  EXPECT_DOUBLE_EQ(surface.volumeMm3, report.volumeMm3);
}

TEST(LabelSurfaces, OfOneVoxelAreClosedAndAsLarge) {
  LabelImage image = tests::emptyLabels();
  image.indexToLps.linear() = Vec3(0.7, -0.8, 3).asDiagonal();
  image.at(5, 5, 5) = 1;
  const auto surfaces = surfacesOf(mapOf(image));
  ASSERT_EQ(surfaces.size(), 1U);
  expectSound(surfaces[0]);
  EXPECT_NEAR(surfaces[0].voxelVolumeMm3, 0.7 * 0.8 * 3, 1e-9);
}

/// What smoothing leaves of a few voxels is next to nothing: to make it as large as they were must not blow
/// it up to shards. These are what a segmentation left over.
TEST(LabelSurfaces, OfScatteredVoxelsStayWhereTheVoxelsAre) {
  LabelImage image = tests::emptyLabels();
  const Vec3 voxel(0.9375, 0.9375, 1.5);
  image.indexToLps.linear() = Vec3(voxel.x(), -voxel.y(), -voxel.z()).asDiagonal();
  for (const auto& [x, y, z] :
       {std::array{6, 2, 1}, {5, 3, 1},  {5, 4, 1},  {5, 5, 1},  {4, 7, 1},  {8, 7, 1},
        {4, 8, 1},           {3, 11, 2}, {5, 10, 5}, {4, 11, 5}, {5, 11, 5}, {6, 11, 5},
        {3, 12, 5},          {6, 12, 5}, {2, 13, 5}, {6, 13, 5}, {3, 14, 5}, {4, 14, 5},
        {5, 14, 5},          {12, 3, 6}, {13, 4, 6}, {18, 3, 6}, {19, 3, 6}})
    image.at(x, y, z) = 1;
  const LabelMap map = mapOf(image);
  const LabelSurface surface = surfacesOf(map).at(0);
  expectSound(surface);
  const Vec3 first = map.indexToLps * Vec3(2, 2, 1), last = map.indexToLps * Vec3(19, 14, 6);
  const Bounds box = boundsOf(surface.mesh.points);
  EXPECT_TRUE((box.low.array() >= (first.cwiseMin(last) - 1.5 * voxel).array()).all()) << box.low.transpose();
  EXPECT_TRUE((box.high.array() <= (first.cwiseMax(last) + 1.5 * voxel).array()).all())
      << box.high.transpose();
}

TEST(LabelSurfaces, OfOrgansThatTheImageCutsOffAreClosed) {
  LabelImage image = tests::emptyLabels();
  image.fill({0, 0, 0}, {23, 19, 15}, 4);
  const auto surfaces = surfacesOf(mapOf(image));
  expectSound(surfaces.at(0));
}

/// Voxels that touch by an edge or a corner only are where contours become non-manifold.
TEST(LabelSurfaces, OfVoxelsThatTouchByEdgesAndCornersAreManifold) {
  LabelImage image = tests::emptyLabels();
  for (int i = 0; i < 6; ++i)
    image.fill({3 * i, 3 * i, 2 * i}, {3 * i + 2, 3 * i + 2, 2 * i + 2}, 1);
  image.fill({1, 16, 2}, {2, 17, 3}, 2);
  image.fill({3, 18, 4}, {4, 19, 5}, 2);
  image.fill({3, 14, 2}, {4, 15, 3}, 2);
  for (const LabelSurface& surface : surfacesOf(mapOf(image)))
    expectSound(surface);
}

TEST(LabelSurfaces, OfNoiseAreManifold) {
  std::mt19937 random(5);
  LabelImage image = tests::emptyLabels();
  for (std::int16_t& voxel : image.voxels)
    voxel = static_cast<std::int16_t>(random() % 3);
  for (const double smoothing : {0.0, 1.0})
    for (const LabelSurface& surface : surfacesOf(mapOf(image), {.segments = {}, .smoothing = smoothing})) {
      const geometry::SurfaceReport report = geometry::checkSurface(surface.mesh);
      EXPECT_TRUE(report.closed()) << report.boundaryEdges;
      EXPECT_TRUE(report.manifold()) << report.nonManifoldEdges;
    }
}

TEST(LabelSurfaces, HaveAboutAsManyTrianglesAsWanted) {
  LabelImage image = tests::emptyLabels({60, 60, 60});
  tests::addBall(image, Vec3(30, 30, 30), 24, 1);
  const LabelMap map = mapOf(image);
  const auto all = surfacesOf(map, {.segments = {}, .triangles = 0});
  EXPECT_GT(all.at(0).mesh.triangles.rows(), 15000);
  for (const int triangles : {500, 2000, 8000}) {
    const auto surfaces = surfacesOf(map, {.segments = {}, .triangles = triangles});
    expectSound(surfaces.at(0));
    EXPECT_NEAR(static_cast<double>(surfaces[0].mesh.triangles.rows()), triangles, 0.05 * triangles);
  }
}

TEST(LabelSurfaces, AreSmoothedWithoutLosingTheirShape) {
  LabelImage image = tests::emptyLabels({60, 60, 60});
  tests::addBall(image, Vec3(30, 30, 30), 20, 1);
  const LabelMap map = mapOf(image);
  const auto roughness = [&](double smoothing) {
    const auto surfaces = surfacesOf(map, {.segments = {}, .triangles = 0, .smoothing = smoothing});
    double worst = 0;
    for (Eigen::Index v = 0; v < surfaces.at(0).mesh.points.rows(); ++v)
      worst = std::max(worst,
                       std::abs((surfaces[0].mesh.points.row(v).transpose() - Vec3(30, 30, 30)).norm() - 20));
    return worst;
  };
  EXPECT_LT(roughness(1), 0.35);
  EXPECT_LT(roughness(1), 0.75 * roughness(0));
  EXPECT_LT(roughness(2), 0.55 * roughness(0));
}

/// Slices three times as thick as voxels are wide: each ends in a step that is many voxels long.
TEST(LabelSurfaces, OfThickSlicesAreWithoutTerraces) {
  const Vec3 voxel(1, 1, 3), middle(30, 30, 30);
  LabelImage image = tests::emptyLabels({61, 61, 21});
  image.indexToLps.linear() = voxel.asDiagonal();
  for (int k = 0; k < 21; ++k)
    for (int j = 0; j < 61; ++j)
      for (int i = 0; i < 61; ++i)
        if ((Vec3(i, j, k).cwiseProduct(voxel) - middle).norm() <= 24)
          image.at(i, j, k) = 1;
  const LabelMap map = mapOf(image);
  /// How much, in degrees, triangles lean away from the ball's surface (root mean square by area).
  const auto unevenness = [&](double smoothing) {
    const LabelSurface surface = surfacesOf(map, {.segments = {}, .smoothing = smoothing}).at(0);
    expectSound(surface);
    const Points& points = surface.mesh.points;
    double sum = 0, areas = 0;
    for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
      const auto corner = [&](int k) -> Vec3 { return points.row(surface.mesh.triangles(t, k)); };
      const Vec3 across = (corner(1) - corner(0)).cross(corner(2) - corner(0));
      const Vec3 outward = (corner(0) + corner(1) + corner(2)) / 3 - middle;
      const double angle = std::atan2(across.cross(outward).norm(), across.dot(outward));
      sum += across.norm() * angle * angle;
      areas += across.norm();
    }
    return std::sqrt(sum / areas) * 180 / std::numbers::pi;
  };
  const double usual = unevenness(LabelSurfaceOptions().smoothing);
  EXPECT_LT(usual, 5);
  EXPECT_LT(usual, 0.6 * unevenness(0.5)) << "a filter that takes the voxels' steps away leaves the slices'";
  EXPECT_LT(unevenness(2), usual);
}

/// Beside a large organ of the same label: what all vertices move by for the volume cannot make up for it.
TEST(LabelSurfaces, OfThinVesselsStayAsThickAsTheyAre) {
  constexpr double kRadius = 1.6, kSlope = 0.2;
  LabelImage image = tests::emptyLabels({60, 40, 100});
  tests::addBall(image, Vec3(30, 20, 20), 16, 1);
  const auto axis = [](double z) { return Vec3(30 + kSlope * (z - 60), 20, z); };
  for (int k = 20; k < 95; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 60; ++i)
        if ((Vec3(i, j, k) - axis(k)).norm() <= kRadius)
          image.at(i, j, k) = 1;
  const LabelMap map = mapOf(image);
  /// The mean distance from the axis, and the end of the vessel.
  const auto shape = [&](double smoothing) {
    const LabelSurface surface = surfacesOf(map, {.segments = {}, .smoothing = smoothing}).at(0);
    expectSound(surface);
    double sum = 0, count = 0, end = 0;
    for (const auto& point : surface.mesh.points.rowwise()) {
      const double z = point.z();
      end = std::max(end, z);
      if (z < 45 || z > 85)
        continue;
      sum += (point.transpose() - axis(z)).norm();
      ++count;
    }
    return std::array{sum / count, end};
  };
  const auto [radius, end] = shape(0);
  for (const double smoothing : {0.5, LabelSurfaceOptions().smoothing, 2.0}) {
    const auto [smoothRadius, smoothEnd] = shape(smoothing);
    EXPECT_NEAR(smoothRadius, radius, 0.05) << smoothing;
    EXPECT_NEAR(smoothEnd, end, 0.5) << smoothing;
  }
}

TEST(LabelSurfaces, KeepAllPiecesOrTheLargestAndSaySo) {
  LabelImage image = tests::emptyLabels();
  image.fill({2, 2, 2}, {10, 10, 10}, 1);
  image.fill({15, 2, 2}, {17, 4, 4}, 1);
  image.at(20, 15, 12) = 1;
  const LabelMap map = mapOf(image);
  const auto all = surfacesOf(map);
  EXPECT_EQ(all.at(0).pieces, 3);
  EXPECT_EQ(geometry::connectedPieces(all[0].mesh).count, 3);
  EXPECT_THAT(inEnglish(all[0].warnings), testing::ElementsAre(testing::HasSubstr("3 pieces, 28 voxels")));
  const auto largest = surfacesOf(map, {.segments = {}, .largestPieceOnly = true});
  expectSound(largest.at(0));
  EXPECT_EQ(largest[0].pieces, 1);
  EXPECT_EQ(geometry::connectedPieces(largest[0].mesh).count, 1);
  EXPECT_NEAR(largest[0].voxelVolumeMm3, 729, 1e-9);
  EXPECT_THAT(inEnglish(largest[0].warnings), testing::ElementsAre(testing::HasSubstr("left out")));
}

TEST(LabelSurfaces, WithACavityHaveItsVolumeLess) {
  LabelImage image = tests::emptyLabels();
  image.fill({2, 2, 2}, {12, 12, 12}, 1);
  image.fill({5, 5, 5}, {9, 9, 9}, 0);
  const auto surfaces = surfacesOf(mapOf(image));
  expectSound(surfaces.at(0));
  EXPECT_EQ(geometry::connectedPieces(surfaces[0].mesh).count, 2);
  EXPECT_NEAR(surfaces[0].voxelVolumeMm3, 1331 - 125, 1e-9);
}

TEST(LabelSurfaces, AreTheSameForAnyNumberOfThreads) {
  LabelImage image = tests::emptyLabels({40, 40, 40});
  tests::addBall(image, Vec3(12, 12, 12), 10, 1);
  tests::addBall(image, Vec3(28, 25, 20), 9, 2);
  tests::addBall(image, Vec3(10, 30, 28), 8, 3);
  const LabelMap map = mapOf(image);
  const LabelSurfaceOptions options{.segments = {2, 0, 1}, .triangles = 1500};
  const auto one = surfacesOf(map, options, Threads{1}), three = surfacesOf(map, options, Threads{3});
  ASSERT_EQ(one.size(), 3U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].segment, options.segments[i]);
    EXPECT_EQ(one[i].mesh.points, three[i].mesh.points);
    EXPECT_EQ(one[i].mesh.triangles, three[i].mesh.triangles);
  }
}

TEST(LabelSurfaces, AreToldOneByOneAsSoonAsTheyAreMade) {
  LabelImage image = tests::emptyLabels({40, 40, 40});
  tests::addBall(image, Vec3(12, 12, 12), 10, 1);
  tests::addBall(image, Vec3(28, 25, 20), 9, 2);
  tests::addBall(image, Vec3(10, 30, 28), 8, 3);
  Progress progress;
  std::atomic<int> telling{0};
  std::map<std::size_t, Points> told;
  const auto surfaces = labelSurfaces(mapOf(image), {}, progress, Threads{3}, [&](const LabelSurface& made) {
    EXPECT_EQ(++telling, 1) << "never by two at a time";
    told[made.segment] = made.mesh.points;
    --telling;
  });
  ASSERT_EQ(told.size(), 3U);
  for (const LabelSurface& surface : surfaces)
    EXPECT_EQ(told.at(surface.segment), surface.mesh.points);
}

TEST(LabelSurfaces, CanBeCancelledAndAreOfSegmentsThatThereAre) {
  LabelImage image = tests::emptyLabels();
  image.fill({2, 2, 2}, {12, 12, 12}, 1);
  const LabelMap map = mapOf(image);
  EXPECT_THROW(surfacesOf(map, {.segments = {1}}), UsageError);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(labelSurfaces(map, {}, progress), Cancelled);
}

} // namespace
} // namespace viscera::medical_io
