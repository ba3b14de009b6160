#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/presentation/contour_bend.h"

namespace viscera::presentation {
namespace {

constexpr double kRingMm = 40;

/// A ring of a radius, and a straight open line far from it.
geometry::PlaneCut ringAndLine() {
  geometry::PlaneCut cut;
  cut.points.resize(123, 3);
  for (int i = 0; i < 120; ++i) {
    const double turn = 2 * std::numbers::pi * i / 120;
    cut.points.row(i) = kRingMm * Eigen::RowVector3d(std::cos(turn), std::sin(turn), 0);
  }
  for (int i = 0; i < 3; ++i)
    cut.points.row(120 + i) = Eigen::RowVector3d(100, 30.0 * i, 0);
  cut.first = {0, 120, 123};
  cut.closed = {true, false};
  return cut;
}

/// How far a point of the ring is from the circle that it was on.
double bulge(const Points& points, Eigen::Index i) {
  return points.row(i).norm() - kRingMm;
}

TEST(ContourBend, TheGrabbedPlaceFollowsAndItsNeighboursFollowLess) {
  ContourBend bend(ringAndLine(), Vec3(kRingMm + 2, 0, 0));
  EXPECT_TRUE(bend.closed());
  EXPECT_EQ(bend.points().rows(), 120) << "the place was a point already";
  bend.dragTo(Vec3(kRingMm + 6, 0, 0));
  EXPECT_NEAR(bend.byMm(), 6, 1e-9);
  EXPECT_NEAR(bulge(bend.points(), 0), 6, 1e-9);
  EXPECT_NEAR(bulge(bend.points(), 5), bulge(bend.points(), 115), 1e-9) << "round the end of a closed line";
  for (Eigen::Index i = 1; i < 20; ++i)
    EXPECT_LT(bulge(bend.points(), i), bulge(bend.points(), i - 1));
  // At the radius along the contour 1/e^2 of the drag is left.
  const auto atRadius = static_cast<Eigen::Index>(
      std::lround(ContourBend::kUsualRadiusMm / (2 * std::numbers::pi * kRingMm) * 120));
  EXPECT_NEAR((bend.points().row(atRadius) - ringAndLine().points.row(atRadius)).norm(), 6 * std::exp(-2),
              0.1);
  EXPECT_NEAR(bulge(bend.points(), 60), 0, 1e-6) << "the far side stays";
}

TEST(ContourBend, OnlyWhatMovedIsACorrection) {
  ContourBend bend(ringAndLine(), Vec3(kRingMm, 0, 0));
  bend.dragTo(Vec3(kRingMm - 4, 0, 0));
  const Points corrected = bend.corrected(), covered = bend.covered();
  ASSERT_EQ(corrected.rows(), covered.rows());
  EXPECT_GT(corrected.rows(), 10);
  EXPECT_LT(corrected.rows(), 60);
  for (Eigen::Index i = 0; i < corrected.rows(); ++i) {
    EXPECT_GE((corrected.row(i) - covered.row(i)).norm(), 0.2 - 1e-9);
    EXPECT_NEAR(covered.row(i).norm(), kRingMm, 1e-9);
  }
}

TEST(ContourBend, ADragBackLeavesTheContourAsItWas) {
  ContourBend bend(ringAndLine(), Vec3(kRingMm, 0, 0));
  bend.dragTo(Vec3(kRingMm + 9, 5, 0));
  bend.dragTo(Vec3(kRingMm, 0, 0));
  EXPECT_LT((bend.points() - ringAndLine().points.topRows(120)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ContourBend, APlaceBetweenPointsBecomesAPoint) {
  ContourBend bend(ringAndLine(), Vec3(105, 10, 0));
  EXPECT_FALSE(bend.closed());
  ASSERT_EQ(bend.points().rows(), 4);
  EXPECT_LT((bend.points().row(1) - Eigen::RowVector3d(100, 10, 0)).norm(), 1e-9);
  bend.dragTo(Vec3(97, 10, 0));
  EXPECT_NEAR(bend.points()(1, 0), 97, 1e-9);
  EXPECT_GT(bend.points()(0, 0), 97);
  EXPECT_LT(bend.points()(0, 0), 99);
}

TEST(ContourBend, RefusesNoContour) {
  EXPECT_THROW(ContourBend({}, Vec3::Zero()), UsageError);
  EXPECT_THROW(ContourBend(ringAndLine(), Vec3::Zero(), 0), UsageError);
}

} // namespace
} // namespace viscera::presentation
