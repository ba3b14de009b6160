#include <numeric>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/surface_series.h"

namespace viscera::tracking {
namespace {

/// A box whose top is open, whose sides are two patches that repeat their common points, one of them wound
/// the other way round; twice, the second time larger.
SurfaceSeries patches() {
  const geometry::TriangleMesh box = tests::box(20, 10, 30);
  SurfaceSeries series{"box", Triangles(10, 3), {}};
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < 12; ++t)
    if (t != 2 && t != 3) // The lid.
      series.triangles.row(kept++) = box.triangles.row(t);
  Points points(16, 3);
  points << box.points, box.points;
  for (Eigen::Index t = 5; t < 10; ++t) { // The second patch has points of its own.
    series.triangles.row(t).array() += 8;
    std::swap(series.triangles(t, 0), series.triangles(t, 1));
  }
  series.phases = {points, 2 * points};
  return series;
}

TEST(TidySeries, ClosesAndTurnsAllPhasesAsTheFirst) {
  const TidySeries tidy = tidySeries(patches());
  EXPECT_EQ(tidy.mergedPoints, 8);
  EXPECT_EQ(tidy.closedHoles, 1);
  EXPECT_EQ(tidy.turnedTriangles, 5);
  EXPECT_NEAR(tidy.mergedApartMm, 0, 1e-12);
  for (std::size_t phase = 0; phase < 2; ++phase) {
    const geometry::TriangleMesh mesh = tidy.series.at(phase);
    const geometry::SurfaceReport report = geometry::checkSurface(mesh);
    EXPECT_TRUE(report.closed() && report.manifold() && report.outward()) << "phase " << phase;
    EXPECT_NEAR(report.volumeMm3, phase == 0 ? 6000 : 48000, 1e-6);
  }
}

TEST(TidySeries, PutsTheMiddleOfACapIntoTheMeanOfItsRim) {
  SurfaceSeries series = patches();
  series.phases[1](4, 2) += 7; // A corner of the rim ...
  series.phases[1](12, 2) += 7;
  const TidySeries tidy = tidySeries(series);
  const Points& first = tidy.series.phases[0];
  const Points& second = tidy.series.phases[1];
  EXPECT_NEAR(first(first.rows() - 1, 2), 30, 1e-12);
  EXPECT_NEAR(second(second.rows() - 1, 2), 60 + 7.0 / 4, 1e-12) << "linear in the rim's points";
}

TEST(TidySeries, SaysHowFarMergedPointsLieApartLater) {
  SurfaceSeries series = patches();
  series.phases[1](12, 0) += 0.5;
  EXPECT_NEAR(tidySeries(series).mergedApartMm, 0.5, 1e-12);
}

TEST(TidySeries, RefusesPhasesWithOtherPoints) {
  SurfaceSeries series = patches();
  series.phases[1].conservativeResize(15, 3);
  try {
    tidySeries(series);
    FAIL() << "must refuse";
  } catch (const DataError& error) {
    EXPECT_NE(error.problem().english().find("Phase 2 has 15 points and the first has 16"), std::string::npos)
        << error.what();
  }
}

TEST(SurfaceSeries, KnowsItsOuterSurfaceAndWhatLiesOutsideOfIt) {
  const std::vector<geometry::TriangleMesh> surfaces = {tests::sphere(2, 10), tests::sphere(2, 30),
                                                        tests::sphere(2, 10, Vec3(30, 0, 0))};
  EXPECT_EQ(outerOf(surfaces), 1U);
  const auto outer = std::make_shared<const geometry::TriangleMesh>(surfaces[1]);
  EXPECT_DOUBLE_EQ(partOutside(surfaces[0], outer, 0), 0);
  EXPECT_NEAR(partOutside(surfaces[2], outer, 0), 0.5, 0.15);
  EXPECT_THROW(outerOf({}), DataError);
}

} // namespace
} // namespace viscera::tracking
