#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/planar.h"
#include "viscera/core/error.h"

/// The systems in the plane: what they promise in space holds there too.
namespace viscera::coordinates {
namespace {

/// Corners of a convex polygon, in order.
PointsOf<2> polygon(int count) {
  PointsOf<2> corners(count, 2);
  for (int i = 0; i < count; ++i)
    corners.row(i) << 50 * std::cos(2 * M_PI * i / count + 0.2) + 3 * std::sin(5.0 * i),
        40 * std::sin(2 * M_PI * i / count + 0.2);
  return corners;
}

PointsOf<2> pointsInside(int count, unsigned seed, double half) {
  return tests::cloud(count, seed, half).leftCols<2>();
}

class PlanarSystem : public testing::TestWithParam<std::string> {};

TEST_P(PlanarSystem, InATriangleIsBarycentric) {
  PointsOf<2> corners(3, 2);
  corners << -30, -20, 45, -10, 5, 50;
  Eigen::Matrix3d frame;
  frame << corners, Eigen::Vector3d::Ones();
  const PointsOf<2> points = pointsInside(40, 3, 9);
  const PlanarWeights found = planarWeights(GetParam(), corners, points);
  ASSERT_TRUE(found.failures.empty());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d expected = Eigen::RowVector3d(points(i, 0), points(i, 1), 1) * frame.inverse();
    EXPECT_LT((found.weights.row(i) - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST_P(PlanarSystem, KeepsIdentityUnityAndPositivity) {
  const PointsOf<2> handles = polygon(9), points = pointsInside(200, 4, 25);
  const PlanarWeights found = planarWeights(GetParam(), handles, points);
  if (GetParam() != "wire-approach") {
    EXPECT_TRUE(found.failures.empty()) << "only the wire has gaps";
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (std::binary_search(found.failures.begin(), found.failures.end(), static_cast<int>(i)))
      continue;
    EXPECT_LT((found.weights.row(i) * handles - points.row(i)).norm(), 1e-10 * 100);
    EXPECT_NEAR(found.weights.row(i).sum(), 1, 1e-12);
    EXPECT_GE(found.weights.row(i).minCoeff(), 0);
  }
}

TEST_P(PlanarSystem, InterpolatesItsHandles) {
  const PointsOf<2> handles = polygon(7);
  const PlanarWeights found = planarWeights(GetParam(), handles, handles);
  EXPECT_TRUE(found.failures.empty());
  EXPECT_LT((found.weights - Eigen::MatrixXd::Identity(7, 7)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(PlanarSystem, InterpolatesHandlesInsideTheHull) {
  PointsOf<2> handles(6, 2);
  handles << -50, -40, 50, -42, 53, 41, 8, 7, -11, 9, -48, 44; // The fourth and the fifth are inside.
  const PlanarWeights found = planarWeights(GetParam(), handles, handles);
  EXPECT_TRUE(found.failures.empty());
  EXPECT_LT((found.weights - Eigen::MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(PlanarSystem, RefusesHandlesOnALineAndUnknownParameters) {
  PointsOf<2> line(4, 2);
  line << 0, 0, 1, 1, 2, 2, 3, 3;
  EXPECT_THROW(planarWeights(GetParam(), line, pointsInside(3, 1, 1)), DataError);
  ParameterValues unknown;
  unknown.set("no-such-parameter", 1);
  EXPECT_THROW(planarWeights(GetParam(), polygon(5), pointsInside(3, 1, 1), unknown), UsageError);
}

INSTANTIATE_TEST_SUITE_P(Systems, PlanarSystem, testing::ValuesIn(planarSystems()), [](const auto& each) {
  std::string name = each.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Planar, MeanValueIsLinearOnEdgesAndNegativeInAConcavePolygon) {
  PointsOf<2> arrow(4, 2);
  arrow << 0, 0, 40, 30, 0, 60, 30, 30; // Handle 3 pushed in.
  PointsOf<2> points(2, 2);
  points << 35, 30, 20, 15;
  const PlanarWeights found = planarWeights("mean-value", arrow, points);
  EXPECT_LT((found.weights * arrow - points).norm(), 1e-12 * 60);
  EXPECT_LT((found.weights.row(1) - Eigen::RowVector4d(0.5, 0.5, 0, 0)).norm(), 1e-12);
  PointsOf<2> arms(8, 2), inOne(1, 2);
  arms << 0, 0, 60, 0, 60, 60, 40, 60, 40, 20, 20, 20, 20, 60, 0, 60; // The letter U.
  inOne << 10, 50;
  EXPECT_LT(planarWeights("mean-value", arms, inOne).weights.minCoeff(), -1e-3);
}

/// Of half tangents by differences nothing would be left: the angles are as small as 1 / distance.
TEST(Planar, MeanValueKeepsIdentityFarOutside) {
  const PointsOf<2> corners = polygon(9);
  for (const double far : {1e2, 1e3, 1e4, 1e5}) {
    PointsOf<2> points(40, 2);
    for (int i = 0; i < 40; ++i)
      points.row(i) << far * std::cos(0.157 * i + 0.01), far * std::sin(0.157 * i + 0.01);
    const PlanarWeights found = planarWeights("mean-value", corners, points);
    EXPECT_TRUE(found.failures.empty());
    // Rounding of the weights, which grow with the distance, times the corners' size.
    EXPECT_LT((found.weights * corners - points).rowwise().norm().maxCoeff(), 1e-13 * far * far / 50) << far;
  }
}

TEST(Planar, PointsOutsideTheHullAreNamed) {
  PointsOf<2> points(3, 2);
  points << 0, 0, 200, 0, 0, -90;
  for (const char* system :
       {"s-celestial", "lagrange-minimisation", "gradient-method", "determinants-approach"})
    EXPECT_EQ(planarWeights(system, polygon(9), points).failures, (std::vector<int>{1, 2})) << system;
}

TEST(Planar, WhatHasNoPlanarFormIsSaid) {
  EXPECT_THROW(planarWeights("green", polygon(5), pointsInside(3, 1, 1)), UsageError);
  ParameterValues all;
  all.set("positivity", 3);
  EXPECT_THROW(planarWeights("lagrange-minimisation", polygon(5), pointsInside(3, 1, 1), all), UsageError);
}

} // namespace
} // namespace viscera::coordinates
