#include "viscera/localised_scc/localised_s_celestial.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "gradient_check.h"
#include "group_scenes.h"
#include "viscera/coordinates/systems.h"
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

std::shared_ptr<const coordinates::CoordinateSystem> localised() {
  return localisedSCelestial({plain("s-celestial"), plain("t-celestial")});
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
  /// Whether the union of the boxes holds a point and what is half a millimetre around it: a face in which
  /// two boxes meet may be crossed.
  bool inside(const Vec3& p) const {
    for (int k = 0; k < 6; ++k)
      if (!holds(p + (k % 2 ? 0.5 : -0.5) * Vec3::Unit(k / 2)))
        return false;
    return true;
  }

private:
  bool holds(const Vec3& p) const {
    for (const auto& box : boxes_)
      if ((p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all())
        return true;
    return false;
  }

  std::vector<tests::Box> boxes_;
  std::mt19937 random_;
};

TEST(LocalisedSCelestial, WithOneGroupIsThePlainSystem) {
  auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {80, 60, 50}}});
  PointsInBoxes inside({{{0, 0, 0}, {80, 60, 50}}}, 1);
  Points points(500, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = inside.next().transpose();
  const auto local = weightsOf(*localised(), handles, points);
  const auto global = weightsOf(*plain(), handles, points);
  EXPECT_LT((local - global).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LocalisedSCelestial, HandlesOfOtherGroupsHaveWeightZero) {
  const auto scene = tests::groupScenes().back(); // The chain.
  const auto handles = tests::groupsOfBoxes(scene.boxes);
  Points points(1, 3);
  points << 10, 20, 20; // In the first region, far from its zone.
  const auto weights = weightsOf(*localised(), handles, points, withOffset(5));
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
  options.parameters.setFromText(localised()->parameters(), "inner", "t-celestial");
  EXPECT_LT(
      (weightsOf(*localised(), handles, points, options) - weightsOf(*plain("t-celestial"), handles, points))
          .cwiseAbs()
          .maxCoeff(),
      1e-12);
}

TEST(LocalisedSCelestial, CountsVerticesInNoRegion) {
  const auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {10, 10, 10}}});
  Points points(3, 3);
  points << 5, 5, 5, 50, 5, 5, 5, 50, 5;
  Progress progress;
  EXPECT_EQ(localised()->bind(handles, points, {}, progress)->report().failures, (std::vector<int>{1, 2}));
}

TEST(LocalisedSCelestial, TellsInItsReportWhatItCutAndWhoMovesNothing) {
  auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {60, 40, 40}}, {{45, 5, 5}, {110, 45, 45}}});
  handles.positions.conservativeResize(handles.positions.rows() + 1, 3);
  handles.positions.bottomRows(1) << 20, 20, 60;
  Points points(1, 3);
  points << 20, 20, 20;
  Progress progress;
  const auto notes = localised()->bind(handles, points, withOffset(500), progress)->report().notes;
  EXPECT_THAT(inEnglish(notes), testing::Contains(testing::HasSubstr("1 handle is in no group")));
  EXPECT_THAT(inEnglish(notes), testing::Contains(testing::HasSubstr("offset of region 'box 1' is cut")));
  handles.positions.conservativeResize(handles.positions.rows() - 1, 3);
  EXPECT_THAT(inEnglish(localised()->bind(handles, points, withOffset(3), progress)->report().notes),
              testing::IsEmpty());
}

TEST(LocalisedSCelestial, DescribesRegionsZonesAndSuperRegionsAndTheOffsetsBound) {
  using Kind = coordinates::SpacePart::Kind;
  const auto handles = tests::groupsOfBoxes(tests::groupScenes().back().boxes); // The chain.
  const auto layout = localised()->layout(handles, withOffset(5).parameters);
  const auto count = [&](Kind kind) {
    return std::count_if(layout.parts.begin(), layout.parts.end(),
                         [kind](const auto& part) { return part.kind == kind; });
  };
  EXPECT_EQ(count(Kind::region), 4);
  EXPECT_EQ(count(Kind::zone), 3);
  EXPECT_EQ(count(Kind::superRegion), 3);
  EXPECT_EQ(layout.parts[1].name, "box 2");
  EXPECT_EQ(layout.parts[1].groups, std::vector<int>{1});
  double widest = 0;
  const RegionLayout regions(handles, 5);
  for (const auto& region : regions.regions())
    widest = std::max(widest, region.offsetBound);
  EXPECT_EQ(layout.upperBounds.at("offset"), widest);
  EXPECT_TRUE(plain()->layout(handles, {}).parts.empty()) << "plain coordinates treat all space alike";
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
  EXPECT_EQ(weightsOf(*localised(), handles, points, one), weightsOf(*localised(), handles, points, three));
}

class MeetingRegions : public testing::TestWithParam<tests::GroupScene> {};

using Segments = std::vector<std::pair<Vec3, Vec3>>;

constexpr int kSegments = 10000;
constexpr double kSegmentLength = 6; ///< mm: its pieces are far shorter than any offset.
constexpr double kZoneOffset = 6;
/// mm. At a handle that lies inside a super-region its coordinate has a cone, which only much shorter pieces
/// resolve.
constexpr double kCone = 2;

/// Segments in random directions around random places in zones, or nearer to one than the offset.
Segments segmentsThroughZones(const tests::GroupScene& scene) {
  const RegionLayout layout(tests::groupsOfBoxes(scene.boxes), kZoneOffset);
  PointsInBoxes inside(scene.boxes, 11);
  std::mt19937 random(12);
  Segments segments;
  while (segments.size() < kSegments) {
    const Vec3 middle = inside.next();
    const auto shares = layout.shares(middle);
    if (shares.empty() || shares.front().set < static_cast<int>(layout.regions().size()))
      continue; // A region alone.
    const Vec3 half = kSegmentLength / 2 * tests::drawDirection(random);
    segments.emplace_back(middle - half, middle + half);
  }
  return segments;
}

/// Largest change of any coordinate between neighbours on the segments cut into `steps` pieces. Points nearer
/// to a handle than `away` do not count.
double largestJump(const tests::GroupScene& scene, const Segments& segments, int steps, double away) {
  const auto handles = tests::groupsOfBoxes(scene.boxes);
  const PointsInBoxes inside(scene.boxes, 0);
  std::vector<Vec3> points;
  std::vector<bool> joined;
  for (const auto& [a, b] : segments) {
    bool open = false;
    for (int i = 0; i <= steps; ++i) {
      const Vec3 p = a + (b - a) * i / steps;
      const bool in = inside.inside(p) &&
                      (handles.positions.rowwise() - p.transpose()).rowwise().norm().minCoeff() >= away;
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
  const auto weights = weightsOf(*localised(), handles, rows, withOffset(kZoneOffset));
  double largest = 0;
  for (Eigen::Index i = 1; i < weights.rows(); ++i)
    if (joined[std::size_t(i)])
      largest = std::max(largest, (weights.row(i) - weights.row(i - 1)).cwiseAbs().maxCoeff());
  return largest;
}

TEST_P(MeetingRegions, TheLargestJumpOnTenThousandSegmentsHalvesWithTheStep) {
  const auto segments = segmentsThroughZones(GetParam());
  const double coarse = largestJump(GetParam(), segments, 25, kCone);
  const double fine = largestJump(GetParam(), segments, 50, kCone);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, 0.6 * coarse) << coarse << ", then " << fine;
}

TEST_P(MeetingRegions, TheLargestJumpHalvesAlsoBesideHandlesInsideASuperRegion) {
  constexpr double kShort = 0.05;
  const auto handles = tests::groupsOfBoxes(GetParam().boxes);
  std::mt19937 random(13);
  Segments segments;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 handle = handles.positions.row(i % handles.positions.rows()).transpose();
    const Vec3 middle = handle + kCone * tests::drawDirection(random),
               half = kShort / 2 * tests::drawDirection(random);
    segments.emplace_back(middle - half, middle + half);
  }
  const double coarse = largestJump(GetParam(), segments, 10, 0);
  const double fine = largestJump(GetParam(), segments, 20, 0);
  EXPECT_LE(fine, 0.6 * coarse) << coarse << ", then " << fine;
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
  const auto gradients = localised()->gradients(handles, centers, withOffset(6), progress);
  const auto weights = weightsOf(*localised(), handles, shifted, withOffset(6));
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

TEST_P(MeetingRegions, GradientsAgreeWithFourthOrderDifferencesAtTenThousandPoints) {
  const auto handles = tests::groupsOfBoxes(GetParam().boxes);
  PointsInBoxes inside(GetParam().boxes, 13);
  constexpr Eigen::Index kCount = 10'000 / 8; // In each of the eight arrangements.
  Points points(kCount, 3);
  Values steps(kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    points.row(i) = inside.next().transpose();
    steps[i] = 2e-3 * (handles.positions.rowwise() - points.row(i)).rowwise().norm().minCoeff();
  }
  const auto check = tests::checkGradients(*localised(), handles, points, steps, withOffset(6), 1e-6);
  EXPECT_LT(check.worst, 1e-6);
  EXPECT_LT(check.unsure, kCount / 20); // On the boundary of a zone, where the second derivative jumps.
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeetingRegions, testing::ValuesIn(tests::groupScenes()),
                         [](const auto& scene) { return scene.param.name; });

} // namespace
} // namespace viscera::localised_scc
