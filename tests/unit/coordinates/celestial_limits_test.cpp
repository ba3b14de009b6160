#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/celestial/celestial_solution.h"
#include "viscera/coordinates/systems.h"

/// Where the convex problem is at its limits: at handles, on the hull's boundary, outside it, and for extreme
/// values.
namespace viscera::coordinates {
namespace {

constexpr double kSize = 200; ///< Diagonal of the handles, mm, roughly.

using FunctionOf = const CelestialFunction& (*)();

class CelestialLimitsTest : public testing::TestWithParam<FunctionOf> {
protected:
  CelestialSolution<3> solve(const Points& points, const CelestialOptions& options = {}) const {
    Progress progress;
    return solveCelestial<3>(GetParam()(), handles_, points, options, progress);
  }

  /// Every point is bound: positive, sums of one, and reproduced to `tolerance` of the size.
  void expectBound(const Points& points, const CelestialOptions& options = {},
                   double tolerance = 1e-12) const {
    const auto solution = solve(points, options);
    EXPECT_TRUE(solution.failures.empty())
        << solution.failures.size() << " failed, first " << solution.failures[0];
    for (Eigen::Index point = 0; point < points.rows(); ++point) {
      Vec3 sum = Vec3::Zero();
      double unity = 0, least = 1;
      for (Eigen::Index handle = 0; handle < handles_.rows(); ++handle) {
        const double weight = solution.weights(point, handle);
        sum += weight * (handles_.row(handle) - points.row(point)).transpose();
        unity += weight;
        least = std::min(least, weight);
      }
      EXPECT_LE(sum.norm(), tolerance * kSize) << point;
      EXPECT_LE(std::abs(unity - 1), 1e-14) << point;
      EXPECT_GE(least, 0) << point;
    }
  }

  /// A cube of handles, corners and two points of each edge and face, with some inside.
  static Points cubeOfHandles() {
    Points handles(8 + 12 + 6 + 4, 3);
    Eigen::Index next = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (x != 0 || y != 0 || z != 0)
            handles.row(next++) << x, y, z;
    handles.bottomRows(4) << 0.1, 0.2, -0.3, -0.4, 0.1, 0.5, 0.6, -0.5, 0, -0.2, -0.6, -0.1;
    // Turned, so that no face is parallel to an axis: that would be too easy on the rounding.
    return (60 * handles * tests::turn(0.6).transpose()).rowwise() + Eigen::RowVector3d(-20, 50, 110);
  }

  /// A point of the cube by its own coordinates in [-1, 1]^3.
  static Eigen::RowVector3d inCube(double x, double y, double z) {
    return 60 * Eigen::RowVector3d(x, y, z) * tests::turn(0.6).transpose() + Eigen::RowVector3d(-20, 50, 110);
  }

  const Points handles_ = cubeOfHandles();
};

const double kFractions[] = {1e-1, 1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                             1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15};

} // namespace

TEST_P(CelestialLimitsTest, AtAHandleItsCoordinateIsOne) {
  const auto solution = solve(handles_);
  EXPECT_TRUE(solution.failures.empty());
  for (Eigen::Index point = 0; point < handles_.rows(); ++point)
    for (Eigen::Index handle = 0; handle < handles_.rows(); ++handle)
      EXPECT_EQ(solution.weights(point, handle), point == handle ? 1 : 0);
}

TEST_P(CelestialLimitsTest, NearAHandleItsCoordinateTendsToOne) {
  for (const double locality : {0.0, 1.0, 3.0, 6.0}) {
    SCOPED_TRACE(locality);
    for (const Eigen::Index handle : {26, 29, 0}) { // Two inside, one corner.
      const Eigen::RowVector3d inward = (inCube(0.03, 0.02, 0.05) - handles_.row(handle)).normalized();
      Points points(std::size(kFractions), 3);
      for (std::size_t i = 0; i < std::size(kFractions); ++i)
        points.row(static_cast<Eigen::Index>(i)) = handles_.row(handle) + kFractions[i] * 60 * inward;
      const CelestialOptions options{locality, 0, {}};
      expectBound(points, options);
      const auto solution = solve(points, options);
      for (Eigen::Index point = 3; point < points.rows(); ++point)
        EXPECT_GT(solution.weights(point, handle), 1 - 100 * kFractions[point]) << "handle " << handle;
    }
  }
}

TEST_P(CelestialLimitsTest, TowardsAFaceAnEdgeAndACornerPointsStayBound) {
  for (const double locality : {0.0, 3.0}) {
    SCOPED_TRACE(locality);
    Points points(3 * std::size(kFractions), 3);
    Eigen::Index next = 0;
    for (const double d : kFractions) {
      points.row(next++) = inCube(1 - d, 0.31, -0.42);
      points.row(next++) = inCube(1 - d, 1 - 2 * d, 0.27);
      points.row(next++) = inCube(1 - d, 1 - 2 * d, 1 - 1.5 * d);
    }
    expectBound(points, {locality, 0, {}}, 1e-11);
    expectBound(points, {locality, 30, {}}, 1e-11);
  }
}

TEST_P(CelestialLimitsTest, OnTheBoundaryItselfPointsAreBoundOrNamed) {
  Points points(300, 3);
  const Points random = tests::cloud(300, 9, 0.95);
  for (Eigen::Index i = 0; i < 300; ++i)
    points.row(i) = inCube(1, random(i, 1), i % 3 == 0 ? -1 : random(i, 2));
  const auto solution = solve(points);
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    if (std::binary_search(solution.failures.begin(), solution.failures.end(), static_cast<int>(point)))
      continue;
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index handle = 0; handle < handles_.rows(); ++handle)
      sum += solution.weights(point, handle) * (handles_.row(handle) - points.row(point)).transpose();
    EXPECT_LE(sum.norm(), 1e-11 * kSize);
  }
  // Rounding moves these points by some 1e-16 to either side, which must not matter.
  EXPECT_EQ(solution.failures.size(), 0u);
}

TEST_P(CelestialLimitsTest, OutsideTheHullEveryPointIsAFailureWithoutNumbers) {
  for (const double d : {1e-9, 1e-6, 1e-3, 0.1, 1.0, 100.0, 1e6}) {
    SCOPED_TRACE(d);
    Points points(5, 3);
    points.row(0) = inCube(1 + d, 0.31, -0.42);
    points.row(1) = inCube(0.2, 0.1, -0.3);
    points.row(2) = inCube(1 + d, 1 + d, 0.27);
    points.row(3) = inCube(-1 - d, 1 + d, 1 + d);
    points.row(4) = inCube(0, -1 - d, 0); // Right over the handle in the middle of a face.
    for (const CelestialOptions& options :
         {CelestialOptions{}, CelestialOptions{3, 0, {}}, CelestialOptions{6, 40, {}}}) {
      const auto solution = solve(points, options);
      EXPECT_EQ(solution.failures, (std::vector<int>{0, 2, 3, 4})) << "locality " << options.locality;
      for (const int failed : solution.failures)
        for (Eigen::Index handle = 0; handle < handles_.rows(); ++handle)
          EXPECT_EQ(solution.weights(failed, handle), 0);
    }
  }
}

TEST_P(CelestialLimitsTest, PointsThatAreNotFiniteFailAloneWithoutNumbers) {
  Points points = tests::cloud(20, 3, 20, {-20, 50, 110});
  const auto clean = solve(points);
  points(4, 1) = std::numeric_limits<double>::quiet_NaN();
  points(11, 2) = std::numeric_limits<double>::infinity();
  points(12, 0) = 1e200;
  const auto solution = solve(points);
  EXPECT_EQ(solution.failures, (std::vector<int>{4, 11, 12}));
  for (const Eigen::Index point : {0, 3, 5, 10, 13, 19})
    for (Eigen::Index handle = 0; handle < handles_.rows(); ++handle)
      EXPECT_EQ(solution.weights(point, handle), clean.weights(point, handle));
}

TEST_P(CelestialLimitsTest, StrongLocalityWithSoftnessIsExactEverywhere) {
  Points points(4000, 3);
  const Points random = tests::cloud(4000, 4, 0.999);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = inCube(random(i, 0), random(i, 1), random(i, 2));
  const double spacing = 60; // Between neighbouring handles of the cube.
  for (const double locality : {2.0, 4.0, 6.0})
    for (const double softness : {0.0, 0.3 * spacing, spacing, 5 * spacing}) {
      SCOPED_TRACE(testing::Message() << "locality " << locality << ", softness " << softness);
      expectBound(points, {locality, softness, {}});
    }
}

TEST_P(CelestialLimitsTest, SizeAndPlaceOfTheSceneDoNotMatter) {
  const Points inside = tests::cloud(50, 3, 20, {-20, 50, 110});
  const auto plain = solve(inside);
  Progress progress;
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    SCOPED_TRACE(scale);
    const auto scaled = solveCelestial<3>(GetParam()(), scale * handles_, scale * inside, {}, progress);
    ASSERT_TRUE(scaled.failures.empty());
    for (Eigen::Index point = 0; point < inside.rows(); ++point)
      for (Eigen::Index handle = 0; handle < handles_.rows(); ++handle)
        EXPECT_NEAR(scaled.weights(point, handle), plain.weights(point, handle), 1e-11);
  }
}

TEST_P(CelestialLimitsTest, ManyHandlesAreNoTrouble) {
  Progress progress;
  const Points handles = tests::onSphere(2000, 100), points = tests::cloud(200, 8, 50);
  HandleSet set;
  set.positions = handles;
  const auto system = GetParam() == sFunction ? sCelestial() : tCelestial();
  const auto binding = system->bind(set, points, {}, progress);
  EXPECT_TRUE(binding->report().failures.empty());
  EXPECT_LT(binding->report().identityError, 1e-12 * kSize);
  EXPECT_GT(binding->report().minWeight, 0);
}

INSTANTIATE_TEST_SUITE_P(Systems, CelestialLimitsTest, testing::Values(sFunction, tFunction),
                         [](const auto& each) {
                           return each.param == sFunction ? "sCelestial" : "tCelestial";
                         });

} // namespace viscera::coordinates
