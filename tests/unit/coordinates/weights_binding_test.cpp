#include "viscera/coordinates/weights_binding.h"

#include <gtest/gtest.h>

#include "clouds.h"

namespace viscera::coordinates {
namespace {

/// Barycentric coordinates of 20 points in the tetrahedron 0, x, y, z, with faults put in on purpose.
struct Tetrahedron {
  Points handles{4, 3};
  Points points = tests::cloud(20, 1, 0.15, {0.2, 0.2, 0.2});
  TiledWeights weights{20, 4};

  Tetrahedron() {
    handles << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      weights.set(i, 0, 1 - points.row(i).sum());
      for (int axis = 0; axis < 3; ++axis)
        weights.set(i, axis + 1, points(i, axis));
    }
  }

  WeightsBinding bind(std::vector<int> failures = {}) const {
    return WeightsBinding(weights, handles, points, std::move(failures), 0.25, {2});
  }
};

} // namespace

TEST(WeightsBinding, ReportsNoErrorForExactCoordinates) {
  const Tetrahedron tetrahedron;
  const BindingReport report = tetrahedron.bind().report();
  EXPECT_LT(report.identityError, 1e-15);
  EXPECT_LT(report.unityError, 1e-15);
  EXPECT_GT(report.minWeight, 0);
  EXPECT_EQ(report.seconds, 0.25);
  EXPECT_EQ(report.threads, 2);
}

TEST(WeightsBinding, MeasuresTheWorstPoint) {
  Tetrahedron tetrahedron;
  const double before = tetrahedron.weights(17, 1);
  tetrahedron.weights.set(17, 1, before + 1e-3); // Handle 1 is at (1, 0, 0): both sums are off by 1e-3.
  tetrahedron.weights.set(3, 2, -0.5);
  const BindingReport report = tetrahedron.bind().report();
  EXPECT_EQ(report.minWeight, -0.5);
  EXPECT_NEAR(report.unityError, 0.5 + tetrahedron.points(3, 1), 1e-12);
  const BindingReport without = tetrahedron.bind({3}).report();
  EXPECT_NEAR(without.identityError, 1e-3, 1e-12);
  EXPECT_NEAR(without.unityError, 1e-3, 1e-12);
  EXPECT_GT(without.minWeight, 0);
}

TEST(WeightsBinding, ShowsAWeightThatIsNotANumber) {
  Tetrahedron tetrahedron;
  tetrahedron.weights.set(7, 2, std::numeric_limits<double>::quiet_NaN());
  const BindingReport report = tetrahedron.bind().report();
  EXPECT_TRUE(std::isnan(report.identityError));
  EXPECT_TRUE(std::isnan(report.unityError));
  EXPECT_TRUE(std::isnan(report.minWeight));
}

TEST(WeightsBinding, MeasuresTheSameFarFromTheOrigin) {
  Tetrahedron tetrahedron;
  const Eigen::RowVector3d far(3000, -2000, 1000);
  tetrahedron.weights.set(17, 1, tetrahedron.weights(17, 1) + 1e-9);
  tetrahedron.weights.set(17, 0, tetrahedron.weights(17, 0) - 1e-9);
  tetrahedron.handles.rowwise() += far;
  tetrahedron.points.rowwise() += far;
  EXPECT_NEAR(tetrahedron.bind().report().identityError, 1e-9, 2e-12);
}

TEST(WeightsBinding, KeepsFailedPointsAtRest) {
  const Tetrahedron tetrahedron;
  const WeightsBinding binding = tetrahedron.bind({0, 16, 19});
  const Points pose = tetrahedron.handles * 2;
  Points points;
  binding.deform(pose, points, {});
  for (const int failed : {0, 16, 19})
    EXPECT_EQ(points.row(failed), tetrahedron.points.row(failed));
  EXPECT_TRUE(points.row(5).isApprox(2 * tetrahedron.points.row(5), 1e-14));
  binding.moveHandle(pose, 1, Vec3(5, 5, 5), points, {});
  EXPECT_EQ(points.row(16), tetrahedron.points.row(16));
  EXPECT_EQ(binding.influence(1)[16], 0);
}

/// A plugin's binding, which knows only what every binding has to.
class ColumnsOnly final : public Binding {
public:
  explicit ColumnsOnly(WeightsBinding binding) : binding_(std::move(binding)) {}
  Eigen::Index handleCount() const override { return binding_.handleCount(); }
  Eigen::Index pointCount() const override { return binding_.pointCount(); }
  const BindingReport& report() const override { return binding_.report(); }
  void deform(const Points& pose, Points& points, Threads threads) const override {
    binding_.deform(pose, points, threads);
  }
  void moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                  Threads threads) const override {
    binding_.moveHandle(pose, handle, delta, points, threads);
  }
  void pullBack(const Points& pose, const Points& gradient, Points& out, Threads threads) const override {
    binding_.pullBack(pose, gradient, out, threads);
  }
  Values influence(int handle) const override { return binding_.influence(handle); }

private:
  WeightsBinding binding_;
};

TEST(WeightsBinding, HasEachNumberOfAColumnAlone) {
  const Tetrahedron tetrahedron;
  const WeightsBinding binding = tetrahedron.bind({0, 16, 19});
  const ColumnsOnly plain(tetrahedron.bind({0, 16, 19}));
  for (int handle = 0; handle < 4; ++handle) {
    const Values column = binding.influence(handle);
    for (Eigen::Index point = 0; point < 20; ++point) {
      EXPECT_EQ(binding.weight(point, handle), column[point]);
      EXPECT_EQ(plain.weight(point, handle), column[point]);
    }
  }
}

TEST(WeightsBinding, LeavesFailedPointsOutOfGradients) {
  const Tetrahedron tetrahedron;
  Points gradient = Points::Zero(20, 3), pulled;
  gradient.row(16) << 1, 2, 3;
  tetrahedron.bind({16}).pullBack(tetrahedron.handles, gradient, pulled, {});
  EXPECT_EQ(pulled, Points::Zero(4, 3));
}

} // namespace viscera::coordinates
