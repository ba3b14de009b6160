#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/celestial/celestial_solution.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

using FunctionOf = const CelestialFunction& (*)();

CelestialSolution<3> solve(FunctionOf function, const Points& handles, const Points& points,
                           const CelestialOptions& options = {}) {
  Progress progress;
  return solveCelestial<3>(function(), handles, points, options, progress);
}

Values row(const TiledWeights& weights, Eigen::Index point) {
  Values values(weights.handles());
  for (Eigen::Index handle = 0; handle < weights.handles(); ++handle)
    values[handle] = weights(point, handle);
  return values;
}

/// exp of the entropy: how many handles share a point.
double effectiveHandles(const Values& weights) {
  double entropy = 0;
  for (const double weight : weights)
    entropy -= weight > 0 ? weight * std::log(weight) : 0;
  return std::exp(entropy);
}

} // namespace

TEST(SCelestial, SolvesTheThesisEquationForAnyLambda) {
  const Points handles = tests::onSphere(15, 40), points = tests::cloud(50, 1, 20);
  const auto solution = solve(sFunction, handles, points);
  for (const double lambda : {1.0, 7.3}) {
    for (Eigen::Index point = 0; point < points.rows(); ++point) {
      // Back from x to the thesis's c: x = c / s with s^2 = lambda^2 + 2 lambda |c|.
      const Vec3 x = solution.x.row(point).transpose();
      const double s = lambda * (x.norm() + std::hypot(x.norm(), 1.0));
      const Vec3 c = s * x;
      Vec3 sum = Vec3::Zero();
      Values weights(handles.rows());
      double total = 0;
      for (Eigen::Index i = 0; i < handles.rows(); ++i) {
        const Vec3 offset = (handles.row(i) - points.row(point)).transpose();
        const Vec3 q = offset.normalized();
        const double mu = q.dot(c) + std::sqrt(q.dot(c) * q.dot(c) + lambda * lambda + 2 * lambda * c.norm());
        sum += mu * mu * q;
        total += mu * mu;
        weights[i] = mu * mu / offset.norm();
      }
      EXPECT_LT(sum.norm(), 1e-12 * total) << "equation 4.22 at point " << point << ", lambda " << lambda;
      EXPECT_LT((weights / weights.sum() - row(solution.weights, point)).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(SCelestial, AcceptsLambdaAndIsNotChangedByIt) {
  HandleSet handles;
  handles.positions = tests::onSphere(12, 30);
  const Points points = tests::cloud(100, 2, 10);
  Progress progress;
  BindOptions options;
  const auto plain = sCelestial()->bind(handles, points, options, progress);
  options.parameters.set("lambda", 7.3);
  const auto other = sCelestial()->bind(handles, points, options, progress);
  for (int handle = 0; handle < 12; ++handle)
    EXPECT_EQ(plain->influence(handle), other->influence(handle));
  options.parameters.set("lambda", 0.5);
  EXPECT_THROW(sCelestial()->bind(handles, points, options, progress), UsageError);
}

TEST(TCelestial, SolvesTheThesisEquation) {
  const Points handles = tests::onSphere(15, 40), points = tests::cloud(50, 1, 20);
  const auto solution = solve(tFunction, handles, points);
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    Vec3 sum = Vec3::Zero();
    Values weights(handles.rows());
    double total = 0;
    for (Eigen::Index i = 0; i < handles.rows(); ++i) {
      const Vec3 offset = (handles.row(i) - points.row(point)).transpose();
      const double power = std::exp(solution.x.row(point).dot(offset.normalized()));
      sum += power * offset.normalized();
      total += power;
      weights[i] = power / offset.norm();
    }
    EXPECT_LT(sum.norm(), 1e-12 * total) << "equation 4.7 at point " << point;
    EXPECT_LT((weights / weights.sum() - row(solution.weights, point)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

class CelestialTest : public testing::TestWithParam<FunctionOf> {};

TEST_P(CelestialTest, ReproducesPointsOfThePlane) {
  PointsOf<2> handles(9, 2), points(200, 2);
  handles = tests::onSphere(9, 20).leftCols<2>();
  points = tests::cloud(200, 3, 6).leftCols<2>();
  Progress progress;
  for (const CelestialOptions& options :
       {CelestialOptions{}, CelestialOptions{2, 0, {}}, CelestialOptions{3, 4, {}}}) {
    const auto solution = solveCelestial<2>(GetParam()(), handles, points, options, progress);
    ASSERT_TRUE(solution.failures.empty());
    for (Eigen::Index point = 0; point < points.rows(); ++point) {
      const Values weights = row(solution.weights, point);
      EXPECT_GT(weights.minCoeff(), 0);
      EXPECT_NEAR(weights.sum(), 1, 1e-14);
      EXPECT_LT((weights.transpose() * handles - points.row(point)).norm(), 1e-11);
    }
  }
}

TEST_P(CelestialTest, OnATriangleIsBarycentric) {
  PointsOf<2> handles(3, 2), points(2, 2);
  handles << 0, 0, 4, 0, 0, 2;
  points << 1, 0.5, 0.1, 1.7;
  Progress progress;
  const auto solution = solveCelestial<2>(GetParam()(), handles, points, {}, progress);
  for (Eigen::Index point = 0; point < 2; ++point) {
    EXPECT_NEAR(solution.weights(point, 1), points(point, 0) / 4, 1e-13);
    EXPECT_NEAR(solution.weights(point, 2), points(point, 1) / 2, 1e-13);
  }
}

TEST_P(CelestialTest, GivesAPointTheSameBitsInAnyCompany) {
  const Points handles = tests::onSphere(20, 50), points = tests::cloud(203, 5, 28);
  const CelestialOptions options{1.5, 0, {}};
  const auto all = solve(GetParam(), handles, points, options);
  for (const Eigen::Index first : {1, 57, 190}) {
    const Points some = points.middleRows(first, 13);
    const auto alone = solve(GetParam(), handles, some, options);
    for (Eigen::Index point = 0; point < some.rows(); ++point)
      EXPECT_EQ(row(alone.weights, point), row(all.weights, first + point)) << first + point;
  }
}

TEST_P(CelestialTest, LocalityConcentratesTheInfluence) {
  // Handles throughout the volume; on a sphere the prior weights would cancel almost entirely.
  Points handles(38, 3);
  handles << tests::onSphere(8, 90), tests::cloud(30, 11, 40);
  const Points points = tests::cloud(100, 6, 30);
  double previous = 39;
  for (const double locality : {0.0, 1.0, 2.0, 3.0, 4.5, 6.0}) {
    const auto solution = solve(GetParam(), handles, points, {locality, 0, {}});
    double mean = 0;
    for (Eigen::Index point = 0; point < points.rows(); ++point)
      mean += effectiveHandles(row(solution.weights, point)) / static_cast<double>(points.rows());
    EXPECT_LT(mean, 0.95 * previous) << "locality " << locality;
    previous = mean;
  }
}

TEST_P(CelestialTest, SoftnessTakesTheKinkAtAHandleAway) {
  Points handles = tests::onSphere(12, 50);
  handles.conservativeResize(13, 3);
  handles.row(12) << 5, -3, 8; // Inside the hull of the others.
  const double h = 1e-4;
  const auto jumpOfSlope = [&](double softness) {
    Points line(3, 3);
    for (int i = 0; i < 3; ++i)
      line.row(i) = handles.row(12) + (i - 1) * h * Eigen::RowVector3d(1, 0, 0);
    const auto solution = solve(GetParam(), handles, line, {0, softness, {}});
    const double left = solution.weights(1, 12) - solution.weights(0, 12);
    const double right = solution.weights(2, 12) - solution.weights(1, 12);
    return std::abs(right - left) / h;
  };
  EXPECT_GT(jumpOfSlope(0), 1e-2) << "a cone";
  EXPECT_LT(jumpOfSlope(10), 1e-4);
}

TEST_P(CelestialTest, ReportsProgressAndStopsWhenCancelled) {
  const Points handles = tests::onSphere(20, 50), points = tests::cloud(20000, 5, 28);
  double last = 0;
  Progress whole([&](double fraction, const Text&) { last = fraction; });
  solveCelestial<3>(GetParam()(), handles, points, {0, 0, {2}}, whole);
  EXPECT_EQ(last, 1);

  std::atomic<int> reports{0};
  Progress cancelled([&](double, const Text&) {
    ++reports;
    cancelled.cancel();
  });
  EXPECT_THROW(solveCelestial<3>(GetParam()(), handles, points, {0, 0, {2}}, cancelled), Cancelled);
  EXPECT_LT(reports, 5) << "the work went on after it was cancelled";
}

INSTANTIATE_TEST_SUITE_P(Systems, CelestialTest, testing::Values(sFunction, tFunction), [](const auto& each) {
  return each.param == sFunction ? "sCelestial" : "tCelestial";
});

} // namespace viscera::coordinates
