#include <cmath>
#include <numbers>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "viscera/deformation/rotational_stress.h"

namespace viscera::deformation {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr int kDegree = 6;

/// The rotational stress of singular values s1 >= s2 >= s3, degrees.
double stress(double s1, double s2, double s3) {
  return kDegrees *
         localDistortion(Eigen::Vector3d(s1, s2, s3).asDiagonal().toDenseMatrix()).rotationalStress;
}

/// A row of monomials x^i y^j, i + j <= 6: x and y between -1 and 1.
Eigen::RowVectorXd monomials(double x, double y) {
  Eigen::RowVectorXd row((kDegree + 1) * (kDegree + 2) / 2);
  Eigen::Index next = 0;
  for (int i = 0; i <= kDegree; ++i)
    for (int j = 0; i + j <= kDegree; ++j)
      row[next++] = std::pow(x, i) * std::pow(y, j);
  return row;
}

/// The largest error in degrees of the best polynomial of degree six in (s1, s3), found by least squares
/// whose weights grow where the error is large (Lawson's iteration for the smallest largest error), over s3
/// from `lowest` to 1 and s1 from s3 to 1: the angle depends on the ratio only, so 1 stands for any size.
double smallestLargestError(double lowest) {
  constexpr int kSteps = 60;
  std::vector<Eigen::Vector3d> samples;
  for (int a = 0; a <= kSteps; ++a)
    for (int b = 0; b <= a; ++b) {
      const double s1 = lowest + (1 - lowest) * a / kSteps, s3 = lowest + (1 - lowest) * b / kSteps;
      samples.emplace_back(s1, s3, stress(s1, (s1 + s3) / 2, s3));
    }
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd rows(count, (kDegree + 1) * (kDegree + 2) / 2);
  Eigen::VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto unit = [&](double s) { return (2 * s - 1 - lowest) / (1 - lowest); };
    rows.row(i) = monomials(unit(samples[std::size_t(i)][0]), unit(samples[std::size_t(i)][1]));
    values[i] = samples[std::size_t(i)][2];
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count) / double(count);
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 60; ++round) {
    const Eigen::VectorXd root = weights.cwiseSqrt();
    const Eigen::VectorXd polynomial =
        (root.asDiagonal() * rows).colPivHouseholderQr().solve(root.cwiseProduct(values));
    const Eigen::VectorXd error = (rows * polynomial - values).cwiseAbs();
    best = std::min(best, error.maxCoeff());
    weights = weights.cwiseProduct(error);
    weights /= weights.sum();
  }
  return best;
}

} // namespace

TEST(StressPolynomial, TheMiddleSingularValuePlaysNoPart) {
  for (const double s2 : {0.4, 0.7, 1.0, 1.9})
    EXPECT_NEAR(stress(2, s2, 0.4), kDegrees * std::asin(1.6 / 2.4), 1e-12);
}

TEST(StressPolynomial, OfDegreeSixIsWithin044DegreesDownToATenthOfTheLargestStretch) {
  // Figure 5.5's claim. Towards s3 = 0 all angles meet in one point and no polynomial follows.
  const double half = smallestLargestError(0.5), tenth = smallestLargestError(0.1);
  RecordProperty("largest_error_deg_from_0.5", std::to_string(half));
  RecordProperty("largest_error_deg_from_0.1", std::to_string(tenth));
  RecordProperty("largest_error_deg_from_0.05", std::to_string(smallestLargestError(0.05)));
  EXPECT_LT(half, tenth);
  EXPECT_LT(tenth, 0.44);
  EXPECT_GT(smallestLargestError(0.001), 0.44);
}

} // namespace viscera::deformation
