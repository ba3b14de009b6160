#include "viscera/localised_scc/localised_s_celestial.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "group_scenes.h"
#include "viscera/coordinates/built_in_systems.h"
#include "viscera/localised_scc/region_layout.h"

namespace viscera::localised_scc {
namespace {

using coordinates::BindOptions;
using coordinates::HandleSet;

std::shared_ptr<const coordinates::CoordinateSystem> plain(const std::string& id = "s-celestial") {
  for (const auto& system : coordinates::builtInSystems())
    if (system->id() == id)
      return system;
  throw std::logic_error(id);
}

LocalisedSCelestial localised() {
  return LocalisedSCelestial({plain("s-celestial"), plain("t-celestial")});
}

Eigen::MatrixXd weightsOf(const coordinates::CoordinateSystem& system, const HandleSet& handles,
                          const Points& points, const BindOptions& options = {}) {
  Progress progress;
  const auto binding = system.bind(handles, points, options, progress);
  EXPECT_TRUE(binding->report().failures.empty());
  Eigen::MatrixXd weights(points.rows(), handles.positions.rows());
  for (Eigen::Index h = 0; h < weights.cols(); ++h)
    weights.col(h) = binding->influence(static_cast<int>(h));
  return weights;
}

BindOptions withOffset(double offset) {
  BindOptions options;
  options.parameters.set("offset", offset);
  return options;
}

/// Random points strictly inside the union of a scene's boxes.
class PointsInBoxes {
public:
  PointsInBoxes(const std::vector<tests::Box>& boxes, unsigned seed) : boxes_(boxes), random_(seed) {}
  Vec3 next() {
    const auto& box = boxes_[std::uniform_int_distribution<std::size_t>(0, boxes_.size() - 1)(random_)];
    Vec3 p;
    for (int k = 0; k < 3; ++k)
      p[k] = std::uniform_real_distribution<double>(box.low[k] + 1, box.high[k] - 1)(random_);
    return p;
  }
  bool inside(const Vec3& p) const {
    for (const auto& box : boxes_)
      if ((p.array() > box.low.array() + 0.5).all() && (p.array() < box.high.array() - 0.5).all())
        return true;
    return false;
  }

private:
  std::vector<tests::Box> boxes_;
  std::mt19937 random_;
};

TEST(LocalisedSCelestial, WithOneGroupIsThePlainSystem) {
  auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {80, 60, 50}}});
  PointsInBoxes inside({{{0, 0, 0}, {80, 60, 50}}}, 1);
  Points points(500, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = inside.next().transpose();
  const auto local = weightsOf(localised(), handles, points);
  const auto global = weightsOf(*plain(), handles, points);
  EXPECT_LT((local - global).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LocalisedSCelestial, HandlesOfOtherGroupsHaveWeightZero) {
  const auto scene = tests::groupScenes().back(); // The chain.
  const auto handles = tests::groupsOfBoxes(scene.boxes);
  Points points(1, 3);
  points << 10, 20, 20; // In the first region, far from its zone.
  const auto weights = weightsOf(localised(), handles, points, withOffset(5));
  for (int h = 0; h < handles.positions.rows(); ++h) {
    const auto& own = handles.groups[0].handles;
    if (std::find(own.begin(), own.end(), h) == own.end()) {
      EXPECT_EQ(weights(0, h), 0) << "handle " << h;
    }
  }
}

TEST(LocalisedSCelestial, TakesTheTCelestialSystemInside) {
  const auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {80, 60, 50}}});
  Points points(1, 3);
  points << 10, 20, 30;
  BindOptions options;
  options.parameters.setFromText(localised().parameters(), "inner", "t-celestial");
  EXPECT_LT(
      (weightsOf(localised(), handles, points, options) - weightsOf(*plain("t-celestial"), handles, points))
          .cwiseAbs()
          .maxCoeff(),
      1e-12);
}

TEST(LocalisedSCelestial, CountsVerticesInNoRegion) {
  const auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {10, 10, 10}}});
  Points points(3, 3);
  points << 5, 5, 5, 50, 5, 5, 5, 50, 5;
  Progress progress;
  EXPECT_EQ(localised().bind(handles, points, {}, progress)->report().failures, (std::vector<int>{1, 2}));
}

TEST(LocalisedSCelestial, IsTheSameToTheBitForAnyNumberOfThreads) {
  const auto scene = tests::groupScenes()[1];
  const auto handles = tests::groupsOfBoxes(scene.boxes);
  PointsInBoxes inside(scene.boxes, 4);
  Points points(3000, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = inside.next().transpose();
  BindOptions one, three;
  one.threads.count = 1;
  three.threads.count = 3;
  EXPECT_EQ(weightsOf(localised(), handles, points, one), weightsOf(localised(), handles, points, three));
}

class MeetingRegions : public testing::TestWithParam<tests::GroupScene> {};

/// Largest change of any coordinate between neighbours on random segments cut into `steps` pieces.
double largestJump(const tests::GroupScene& scene, int segments, int steps) {
  const auto handles = tests::groupsOfBoxes(scene.boxes);
  PointsInBoxes inside(scene.boxes, 11);
  std::vector<Vec3> points;
  std::vector<bool> joined;
  for (int s = 0; s < segments; ++s) {
    const Vec3 a = inside.next(), b = inside.next();
    bool open = false;
    for (int i = 0; i <= steps; ++i) {
      const Vec3 p = a + (b - a) * i / steps;
      const bool in = inside.inside(p);
      if (in) {
        points.push_back(p);
        joined.push_back(open);
      }
      open = in;
    }
  }
  Points rows(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  const auto weights = weightsOf(localised(), handles, rows, withOffset(6));
  double largest = 0;
  for (Eigen::Index i = 1; i < weights.rows(); ++i)
    if (joined[std::size_t(i)])
      largest = std::max(largest, (weights.row(i) - weights.row(i - 1)).cwiseAbs().maxCoeff());
  return largest;
}

TEST_P(MeetingRegions, CoordinatesAreContinuousAlongRandomSegments) {
  const double coarse = largestJump(GetParam(), 1500, 200);
  const double fine = largestJump(GetParam(), 1500, 400);
  EXPECT_LT(fine, 0.65 * coarse);
}

TEST_P(MeetingRegions, GradientsAgreeWithCentralDifferences) {
  const auto handles = tests::groupsOfBoxes(GetParam().boxes);
  PointsInBoxes inside(GetParam().boxes, 12);
  const Eigen::Index count = 200, n = handles.positions.rows();
  const double step = 1e-4;
  Points centers(count, 3), shifted(6 * count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    centers.row(i) = inside.next().transpose();
    for (int k = 0; k < 3; ++k) {
      shifted.row(6 * i + 2 * k) = centers.row(i) + step * Eigen::RowVector3d::Unit(k);
      shifted.row(6 * i + 2 * k + 1) = centers.row(i) - step * Eigen::RowVector3d::Unit(k);
    }
  }
  Progress progress;
  const auto gradients = localised().gradients(handles, centers, withOffset(6), progress);
  const auto weights = weightsOf(localised(), handles, shifted, withOffset(6));
  const RegionLayout layout(handles, 6);
  for (Eigen::Index i = 0; i < count; ++i) {
    // Across a zone's boundary the second derivative jumps, so differences say nothing there.
    bool smooth = true;
    for (int k = 0; k < 6; ++k)
      smooth &= layout.shares(shifted.row(6 * i + k).transpose()).size() ==
                layout.shares(centers.row(i).transpose()).size();
    if (!smooth)
      continue;
    for (int k = 0; k < 3; ++k) {
      const Values differences =
          (weights.row(6 * i + 2 * k) - weights.row(6 * i + 2 * k + 1)).transpose() / (2 * step);
      const Values exact = gradients.values.middleRows(i * n, n).col(k);
      EXPECT_LT((differences - exact).cwiseAbs().maxCoeff(), 1e-5 * (0.1 + exact.cwiseAbs().maxCoeff()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeetingRegions, testing::ValuesIn(tests::groupScenes()),
                         [](const auto& scene) { return scene.param.name; });

} // namespace
} // namespace viscera::localised_scc
