#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/systems.h"

namespace viscera::coordinates {
namespace {

using System = std::shared_ptr<const CoordinateSystem>;

/// A system with a locality and a softness (mm).
class CelestialGradientsTest : public testing::TestWithParam<std::tuple<System, double, double>> {
protected:
  CelestialGradientsTest() {
    const auto& [system, locality, softness] = GetParam();
    handles_.positions = tests::onSphere(14, 50, {10, 20, 30});
    options_.parameters.set("locality", locality);
    options_.parameters.set("softness", softness);
  }

  const CoordinateSystem& system() const { return *std::get<0>(GetParam()); }

  HandleSet handles_;
  BindOptions options_;
  Progress progress_;
};

} // namespace

TEST_P(CelestialGradientsTest, InClosedFormAgreeWithDifferences) {
  const Points points = tests::cloud(60, 2, 24, {10, 20, 30});
  const auto exact = system().gradients(handles_, points, options_, progress_);
  const auto differences = system().CoordinateSystem::gradients(handles_, points, options_, progress_);
  EXPECT_TRUE(exact.closedForm);
  EXPECT_FALSE(differences.closedForm);
  EXPECT_TRUE(exact.failures.empty());
  EXPECT_LT((exact.values - differences.values).cwiseAbs().maxCoeff(),
            1e-7 * exact.values.cwiseAbs().maxCoeff());
}

TEST_P(CelestialGradientsTest, SumToZeroAndReproduceTheIdentity) {
  const Points points = tests::cloud(60, 2, 24, {10, 20, 30});
  const auto gradients = system().gradients(handles_, points, options_, progress_);
  const Eigen::Index count = handles_.positions.rows();
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    const Points rows = gradients.values.middleRows(point * count, count);
    EXPECT_LT(rows.colwise().sum().norm(), 1e-13 * rows.norm());
    const Eigen::Matrix3d jacobian = handles_.positions.transpose() * rows;
    EXPECT_LT((jacobian - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST_P(CelestialGradientsTest, HaveZeroRowsForPointsOutside) {
  Points points = tests::cloud(4, 2, 24, {10, 20, 30});
  points.row(2) << 500, 0, 0;
  const auto gradients = system().gradients(handles_, points, options_, progress_);
  EXPECT_EQ(gradients.failures, std::vector<int>{2});
  const Eigen::Index count = handles_.positions.rows();
  EXPECT_EQ(gradients.values.middleRows(2 * count, count), Points::Zero(count, 3));
  EXPECT_GT(gradients.values.middleRows(3 * count, count).norm(), 0);
}

TEST_P(CelestialGradientsTest, GiveTheSameBitsForAnyNumberOfThreads) {
  const Points points = tests::cloud(600, 2, 24, {10, 20, 30});
  options_.threads.count = 1;
  const auto one = system().gradients(handles_, points, options_, progress_);
  options_.threads.count = 3;
  EXPECT_EQ(system().gradients(handles_, points, options_, progress_).values, one.values);
}

TEST_P(CelestialGradientsTest, AtAHandleExistWithSoftnessOnly) {
  handles_.positions.row(5) << 12, 17, 33; // Inside the others' hull.
  const Points points = handles_.positions.middleRows(5, 1);
  const auto gradients = system().gradients(handles_, points, options_, progress_);
  const bool soft = std::get<2>(GetParam()) > 0;
  EXPECT_EQ(gradients.failures.size(), soft ? 0u : 1u);
  EXPECT_TRUE(gradients.values.allFinite());
  EXPECT_EQ(gradients.values.norm() > 0, soft);
}

INSTANTIATE_TEST_SUITE_P(Systems, CelestialGradientsTest,
                         testing::Combine(testing::Values(sCelestial(), tCelestial()),
                                          testing::Values(0.0, 2.5), testing::Values(0.0, 12.0)));

} // namespace viscera::coordinates
