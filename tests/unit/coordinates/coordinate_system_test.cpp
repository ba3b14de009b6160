#include "viscera/coordinates/coordinate_system.h"

#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/coordinates/systems.h"
#include "viscera/coordinates/weights_binding.h"

namespace viscera::coordinates {
namespace {

/// Barycentric coordinates of a tetrahedron whose points are not inside fail; differentiated by the standard
/// way.
class Barycentric final : public CoordinateSystem {
public:
  std::string id() const override { return "barycentric"; }
  std::string name() const override { return "Barycentric"; }
  std::string summary() const override { return "For tests"; }
  Traits traits() const override { return {}; }
  std::vector<Parameter> parameters() const override { return {}; }

  std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points, const BindOptions& options,
                                Progress&) const override {
    Eigen::Matrix4d corners;
    corners << handles.positions, Eigen::Vector4d::Ones();
    const Eigen::Matrix4d inverse = corners.inverse();
    TiledWeights weights(points.rows(), 4);
    std::vector<int> failures;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Eigen::RowVector4d a = Eigen::RowVector4d(points(i, 0), points(i, 1), points(i, 2), 1) * inverse;
      for (int j = 0; j < 4; ++j)
        weights.set(i, j, a[j]);
      if (a.minCoeff() < 0)
        failures.push_back(static_cast<int>(i));
    }
    return std::make_unique<WeightsBinding>(std::move(weights), handles.positions, points, failures, 0,
                                            options.threads);
  }
};

/// Takes its time for each point, as some attempts of the thesis with many handles.
class Slow final : public PointSolver {
public:
  bool solve(const Vec3&, Values& weights) const override {
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    weights.setConstant(1.0 / static_cast<double>(weights.size()));
    return true;
  }
};

} // namespace

TEST(CoordinateSystem, DifferentiatesByCentralDifferences) {
  HandleSet handles;
  handles.positions.resize(4, 3);
  handles.positions << 0, 0, 0, 20, 0, 0, 0, 10, 0, 0, 0, 5;
  Points points(3, 3);
  points << 2, 2, 1, 30, 0, 0, 1, 1, 1;
  Progress progress;
  const auto gradients = Barycentric().gradients(handles, points, {}, progress);
  EXPECT_FALSE(gradients.closedForm);
  ASSERT_EQ(gradients.values.rows(), 12);
  EXPECT_EQ(gradients.failures, std::vector<int>{1});
  Points expected(4, 3);
  expected << -0.05, -0.1, -0.2, 0.05, 0, 0, 0, 0.1, 0, 0, 0, 0.2;
  EXPECT_LT((gradients.values.topRows(4) - expected).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((gradients.values.bottomRows(4) - expected).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(gradients.values.middleRows(4, 4), Points::Zero(4, 3));
}

/// Or a slow system looks as if it hung: threads take many points at once.
TEST(PointwiseSystem, ReportsItsProgressWithinTheFirstPointsOfASlowSystem) {
  const PointwiseSystem slow({"slow", "Slow", "For tests", {}},
                             PointwiseSystem::Prepare([](const HandleSet&, const ParameterValues&) {
                               return std::make_unique<const Slow>();
                             }));
  HandleSet handles;
  handles.positions.resize(4, 3);
  handles.positions << 0, 0, 0, 20, 0, 0, 0, 10, 0, 0, 0, 5;
  std::vector<double> reports;
  Progress progress([&](double fraction, const Text&) { reports.push_back(fraction); });
  BindOptions options;
  options.threads = Threads{1};
  slow.bind(handles, Points::Constant(4, 3, 1), options, progress);
  EXPECT_EQ(reports, (std::vector<double>{0.25, 0.5, 0.75, 1}));
}

TEST(BuiltInSystems, HaveDifferentNames) {
  std::set<std::string> ids, names;
  for (const auto& system : builtInSystems()) {
    EXPECT_TRUE(ids.insert(system->id()).second) << system->id();
    EXPECT_TRUE(names.insert(system->name()).second) << system->name();
  }
  EXPECT_TRUE(ids.count("s-celestial"));
  EXPECT_TRUE(ids.count("t-celestial"));
}

} // namespace viscera::coordinates
