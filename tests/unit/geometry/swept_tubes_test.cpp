#include "viscera/geometry/swept_tubes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// A straight line of 20 mm and a quarter of a circle with a radius of 20 mm, 41 points each.
Points twoLines() {
  constexpr int kPoints = 41;
  Points lines(2 * kPoints, 3);
  for (int i = 0; i < kPoints; ++i) {
    const double part = static_cast<double>(i) / (kPoints - 1);
    const double angle = part * std::numbers::pi / 2;
    lines.row(i) << 0, 0, 20 * part;
    lines.row(kPoints + i) << 50 + 20 * std::cos(angle), 20 * std::sin(angle), 0;
  }
  return lines;
}

TriangleMesh meshOf(const SweptTubes& tubes, const Points& lines) {
  TriangleMesh mesh;
  tubes.at(lines, mesh.points);
  mesh.triangles = tubes.triangles();
  return mesh;
}

TEST(SweptTubes, AreClosedSurfacesOfTheVolumeOfTheirCylinders) {
  const Points lines = twoLines();
  const SweptTubes tubes({41, 41}, Values::Constant(82, 2));
  const TriangleMesh mesh = meshOf(tubes, lines);
  const SurfaceReport report = checkSurface(mesh);
  EXPECT_TRUE(report.closed() && report.manifold());
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(mesh.points.rows(), tubes.points());
  // A polygon of ten sides has 0.935 of its circle's area; each blunt end adds a flat cone.
  const double section = 0.935 * std::numbers::pi * 4;
  const double wanted = section * (20 + 10 * std::numbers::pi + 4.0 / 3);
  EXPECT_NEAR(volume(mesh.points, mesh.triangles), wanted, 0.02 * wanted) << "positive: outward";
}

TEST(SweptTubes, StayRoundWhereTheirLinesAreMoved) {
  Points lines = twoLines();
  lines.col(0) *= 2;
  Values radii = Values::Constant(82, 1.5);
  radii[40] = 0.5;
  const SweptTubes tubes({41, 41}, radii);
  const TriangleMesh mesh = meshOf(tubes, lines);
  for (Eigen::Index i = 0; i < 41; ++i)
    for (int side = 0; side < SweptTubes::kSides; ++side)
      EXPECT_NEAR((mesh.points.row(i * SweptTubes::kSides + side) - lines.row(i)).norm(), radii[i], 1e-9);
}

TEST(SweptTubes, RefuseLinesThatDoNotFit) {
  EXPECT_THROW(SweptTubes({1}, Values::Constant(1, 1)), UsageError);
  EXPECT_THROW(SweptTubes({2}, Values::Constant(3, 1)), UsageError);
  Points out;
  EXPECT_THROW(SweptTubes({2}, Values::Constant(2, 1)).at(Points::Zero(3, 3), out), UsageError);
}

} // namespace
} // namespace viscera::geometry
