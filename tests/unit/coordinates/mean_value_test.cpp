#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

constexpr double kRadius = 50;

HandleSet sphereCage(int count = 18) {
  HandleSet handles;
  handles.positions = tests::onSphere(count, kRadius);
  handles.cage = geometry::ConvexHull(handles.positions).triangles();
  return handles;
}

/// A box with a pit in its top: not convex.
HandleSet boxWithPit() {
  const auto box = tests::box(80, 80, 80);
  HandleSet handles;
  handles.positions.resize(9, 3);
  handles.positions.topRows(8) = box.points;
  const double top = box.points.col(2).maxCoeff();
  handles.positions.row(8) = box.points.colwise().mean();
  std::vector<Eigen::RowVector3i> triangles;
  for (Eigen::Index t = 0; t < box.triangles.rows(); ++t) {
    bool onTop = true;
    for (int corner = 0; corner < 3; ++corner)
      onTop = onTop && box.points(box.triangles(t, corner), 2) == top;
    if (!onTop)
      triangles.emplace_back(box.triangles.row(t));
  }
  // The rim runs against its neighbours' edges; every rim edge makes a triangle with the pit.
  std::vector<std::pair<int, int>> directed;
  for (const auto& triangle : triangles)
    for (int corner = 0; corner < 3; ++corner)
      directed.emplace_back(triangle[corner], triangle[(corner + 1) % 3]);
  for (const auto& [from, to] : std::vector<std::pair<int, int>>(directed))
    if (std::find(directed.begin(), directed.end(), std::pair(to, from)) == directed.end())
      triangles.emplace_back(to, from, 8);
  handles.cage.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    handles.cage.row(static_cast<Eigen::Index>(t)) = triangles[t];
  return handles;
}

Points pointsIn(const HandleSet& handles, int count, unsigned seed, double depth) {
  const geometry::ConvexHull hull(handles.positions);
  Points all = tests::cloud(count, seed, kRadius);
  Eigen::Index inside = 0;
  for (Eigen::Index i = 0; i < all.rows(); ++i)
    if (hull.signedDistance(all.row(i).transpose()) < -depth)
      all.row(inside++) = all.row(i);
  return all.topRows(inside);
}

std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points) {
  Progress progress;
  return meanValue()->bind(handles, points, {}, progress);
}

Eigen::MatrixXd weightsAt(const HandleSet& handles, const Points& points) {
  const auto binding = bind(handles, points);
  Eigen::MatrixXd weights(points.rows(), handles.positions.rows());
  for (int i = 0; i < weights.cols(); ++i)
    weights.col(i) = binding->influence(i);
  return weights;
}

TEST(MeanValue, ArePositiveInsideAConvexCage) {
  const HandleSet handles = sphereCage();
  EXPECT_GT(bind(handles, pointsIn(handles, 5000, 1, 0.01))->report().minWeight, 0);
}

TEST(MeanValue, AreNegativeSomewhereInACageWithAPit) {
  const HandleSet handles = boxWithPit();
  Points points = tests::cloud(2000, 2, 39, handles.positions.row(8).transpose());
  const auto report = bind(handles, points)->report();
  EXPECT_LT(report.minWeight, -1e-3);
  EXPECT_LT(report.identityError, 1e-9 * 80);
}

TEST(MeanValue, OnAFaceOfTheCageAreItsBarycentricCoordinates) {
  const HandleSet handles = sphereCage();
  const Vec3 shares(0.2, 0.5, 0.3);
  for (Eigen::Index t = 0; t < handles.cage.rows(); ++t) {
    Points point = Points::Zero(1, 3);
    Values expected = Values::Zero(handles.positions.rows());
    for (int corner = 0; corner < 3; ++corner) {
      point += shares[corner] * handles.positions.row(handles.cage(t, corner));
      expected[handles.cage(t, corner)] = shares[corner];
    }
    EXPECT_LT((weightsAt(handles, point).row(0).transpose() - expected).cwiseAbs().maxCoeff(), 1e-8) << t;
  }
}

TEST(MeanValue, AreContinuousAcrossTheFacesOfTheCage) {
  const HandleSet handles = sphereCage();
  const auto corners = handles.cage.row(3);
  const Eigen::RowVector3d middle = (handles.positions.row(corners[0]) + handles.positions.row(corners[1]) +
                                     handles.positions.row(corners[2])) /
                                    3;
  Points on(1, 3), beside(1, 3);
  on.row(0) = middle;
  double before = 1;
  for (const double step : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    beside.row(0) = middle * (1 - step);
    const double jump = (weightsAt(handles, beside) - weightsAt(handles, on)).cwiseAbs().maxCoeff();
    EXPECT_LT(jump, std::max(before, 1e-8)) << step;
    EXPECT_LT(jump, 40 * std::sqrt(step)) << step;
    before = jump;
  }
}

/// Planes of triangles pass through the whole inside; nothing happens there but rounding.
TEST(MeanValue, LoseNothingInTheExtendedPlanesOfTheFaces) {
  const HandleSet handles = boxWithPit();
  const Points pit = handles.positions.row(8);
  const Points& corners = handles.positions;
  Points points(600, 3);
  const Points shares = tests::cloud(600, 5, 2, Vec3::Constant(0.4));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto triangle = handles.cage.row(i % handles.cage.rows());
    const double third = 1 - shares(i, 0) - shares(i, 1);
    points.row(i) = shares(i, 0) * corners.row(triangle[0]) + shares(i, 1) * corners.row(triangle[1]) +
                    third * corners.row(triangle[2]);
    // In the plane, and a hair's breadth off it.
    points(i, 1) += std::pow(10.0, -2 - static_cast<double>(i % 12)) * (i % 3);
  }
  EXPECT_LT(bind(handles, points)->report().identityError, 1e-6);
  EXPECT_TRUE(bind(handles, points)->report().failures.empty());
}

TEST(MeanValue, TakeTheConvexHullWhereNoCageIsGiven) {
  HandleSet handles = sphereCage();
  const Points points = pointsIn(handles, 300, 3, 1);
  const Eigen::MatrixXd withCage = weightsAt(handles, points);
  handles.cage.resize(0, 3);
  EXPECT_EQ(weightsAt(handles, points), withCage);
}

TEST(MeanValue, RefuseAnOpenCageWithTheNumberOfItsEdges) {
  HandleSet handles = sphereCage();
  const Triangles closed = handles.cage;
  handles.cage = closed.topRows(closed.rows() - 1);
  try {
    bind(handles, pointsIn(handles, 10, 3, 1));
    FAIL() << "an open cage was taken";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("3 edges"));
  }
  handles.cage = closed;
  handles.cage(0, 0) = 99;
  EXPECT_THROW(bind(handles, pointsIn(sphereCage(), 10, 3, 1)), DataError);
}

/// Differences of the fourth order, at a step that fits the distance to the cage.
Eigen::MatrixXd differences(const HandleSet& handles, const Eigen::RowVector3d& point, double step) {
  Eigen::MatrixXd slopes(handles.positions.rows(), 3);
  for (int axis = 0; axis < 3; ++axis) {
    Points around(4, 3);
    const Eigen::RowVector3d unit = step * Eigen::RowVector3d::Unit(axis);
    around << point + unit, point - unit, point + 2 * unit, point - 2 * unit;
    const Eigen::MatrixXd weights = weightsAt(handles, around);
    slopes.col(axis) =
        ((8 * (weights.row(0) - weights.row(1)) - (weights.row(2) - weights.row(3))) / (12 * step))
            .transpose();
  }
  return slopes;
}

void expectSlopes(const HandleSet& handles, const Points& points, double step) {
  Progress progress;
  const auto gradients = meanValue()->gradients(handles, points, {}, progress);
  ASSERT_TRUE(gradients.closedForm);
  ASSERT_TRUE(gradients.failures.empty());
  const Eigen::Index count = handles.positions.rows();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::MatrixXd expected = differences(handles, points.row(i), step);
    const double error = (gradients.values.middleRows(i * count, count) - expected).cwiseAbs().maxCoeff();
    ASSERT_LT(error, 1e-6 * expected.cwiseAbs().maxCoeff()) << "point " << i;
  }
}

TEST(MeanValueGradients, AreTheDerivativesAtTenThousandPoints) {
  const HandleSet handles = sphereCage();
  const Points points = pointsIn(handles, 31000, 11, 1);
  ASSERT_GE(points.rows(), 10000);
  expectSlopes(handles, points.topRows(10000), 1e-2);
}

TEST(MeanValueGradients, AreTheDerivativesNearHandlesAndNearTheCage) {
  const HandleSet handles = sphereCage();
  const geometry::ConvexHull hull(handles.positions);
  Points near(200, 3);
  Eigen::Index found = 0;
  const Points shares = tests::cloud(600, 12, 0.5, Vec3::Constant(0.5));
  for (Eigen::Index i = 0; i < 600 && found < 200; ++i) {
    const auto triangle = handles.cage.row(i % handles.cage.rows());
    const Eigen::RowVector3d sums = shares.row(i) / shares.row(i).sum();
    Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
    for (int corner = 0; corner < 3; ++corner)
      point += sums[corner] * handles.positions.row(triangle[corner]);
    if (i % 2 == 0) // Near a handle instead.
      point = handles.positions.row(triangle[0]) + 0.01 * (point - handles.positions.row(triangle[0]));
    point *= 1 - 2e-3;
    if (hull.signedDistance(point.transpose()) < -0.05)
      near.row(found++) = point;
  }
  ASSERT_GT(found, 150);
  expectSlopes(handles, near.topRows(found), 2e-4);
}

TEST(MeanValueGradients, DoNotExistOnTheCage) {
  const HandleSet handles = sphereCage();
  Progress progress;
  const Points corner = handles.positions.row(4);
  EXPECT_EQ(meanValue()->gradients(handles, corner, {}, progress).failures, std::vector<int>{0});
}

} // namespace
} // namespace viscera::coordinates
