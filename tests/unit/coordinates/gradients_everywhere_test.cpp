#include <gtest/gtest.h>

#include "clouds.h"
#include "gradient_check.h"
#include "viscera/coordinates/systems.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

constexpr double kTolerance = 1e-6;

/// Fourteen handles on a sphere, and points inside with their distance from all handles and from the hull.
class GradientsEverywhere : public testing::TestWithParam<std::shared_ptr<const CoordinateSystem>> {
protected:
  GradientsEverywhere() { handles_.positions = tests::onSphere(14, 50, {10, 20, 30}); }

  void expectExact(const Points& points) {
    const geometry::ConvexHull hull(handles_.positions);
    Values steps(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double nearest = (handles_.positions.rowwise() - points.row(i)).rowwise().norm().minCoeff();
      steps[i] = 2e-3 * std::min(nearest, -hull.signedDistance(points.row(i).transpose()));
      ASSERT_GT(steps[i], 0);
    }
    const auto check = tests::checkGradients(*GetParam(), handles_, points, steps, {}, kTolerance);
    EXPECT_LT(check.worst, kTolerance);
    EXPECT_LE(check.unsure, points.rows() / 1000);
  }

  HandleSet handles_;
};

} // namespace

TEST_P(GradientsEverywhere, AgreeWithDifferencesAtTenThousandPoints) {
  expectExact(tests::cloud(10'000, 5, 20, {10, 20, 30}));
}

TEST_P(GradientsEverywhere, AgreeWithDifferencesNearHandlesAndNearTheHull) {
  const Points inside = tests::cloud(300, 6, 15, {10, 20, 30});
  const geometry::ConvexHull hull(handles_.positions);
  for (const double left : {0.1, 0.03}) {
    Points near(2 * inside.rows(), 3);
    for (Eigen::Index i = 0; i < inside.rows(); ++i) {
      const Eigen::RowVector3d handle = handles_.positions.row(i % 14);
      near.row(2 * i) = handle + left * (inside.row(i) - handle);
      const auto t = hull.triangles().row(i % hull.triangles().rows());
      const Eigen::RowVector3d facet =
          (handles_.positions.row(t[0]) + handles_.positions.row(t[1]) + handles_.positions.row(t[2])) / 3;
      near.row(2 * i + 1) = facet + left * (inside.row(i) - facet);
    }
    expectExact(near);
  }
}

INSTANTIATE_TEST_SUITE_P(Systems, GradientsEverywhere,
                         testing::Values(sCelestial(), tCelestial(), meanValue()));

} // namespace viscera::coordinates
