#include "viscera/deformation/stress_polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/QR>

#include "viscera/deformation/rotational_stress.h"

namespace viscera::deformation {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr int kDegree = 6;
constexpr Eigen::Index kTerms = (kDegree + 1) * (kDegree + 2) / 2;
constexpr int kPolynomialSteps = 60;
constexpr int kRounds = 60;
constexpr int kDirections = 400; ///< From pole to pole and around, for the search.

/// The monomials x^i y^j, i + j <= 6, of s1 and s3 brought to -1 to 1.
Eigen::RowVectorXd monomials(double s1, double s3, double lowest) {
  const auto unit = [&](double s) { return (2 * s - 1 - lowest) / (1 - lowest); };
  const double x = unit(s1), y = unit(s3);
  Eigen::RowVectorXd row(kTerms);
  Eigen::Index next = 0;
  for (int i = 0; i <= kDegree; ++i)
    for (int j = 0; i + j <= kDegree; ++j)
      row[next++] = std::pow(x, i) * std::pow(y, j);
  return row;
}

} // namespace

StressPolynomial::StressPolynomial(double lowest)
    : lowest_(lowest), largestError_(std::numeric_limits<double>::infinity()) {
  constexpr Eigen::Index kCount = (kPolynomialSteps + 1) * (kPolynomialSteps + 2) / 2;
  Eigen::MatrixXd rows(kCount, kTerms);
  Eigen::VectorXd values(kCount);
  Eigen::Index next = 0;
  for (int a = 0; a <= kPolynomialSteps; ++a)
    for (int b = 0; b <= a; ++b, ++next) {
      const double s1 = lowest + (1 - lowest) * a / kPolynomialSteps,
                   s3 = lowest + (1 - lowest) * b / kPolynomialSteps;
      rows.row(next) = monomials(s1, s3, lowest);
      values[next] = stressDegrees(s1, (s1 + s3) / 2, s3);
    }
  // Lawson's iteration for the least largest error: min sum w_k (P(x_k) - y_k)^2, and w_k grows by |P(x_k) -
  // y_k| before the next.
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(kCount) / static_cast<double>(kCount);
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd root = weights.cwiseSqrt();
    const Eigen::VectorXd fitted =
        (root.asDiagonal() * rows).colPivHouseholderQr().solve(root.cwiseProduct(values));
    const Eigen::VectorXd error = (rows * fitted - values).cwiseAbs();
    if (error.maxCoeff() < largestError_) {
      largestError_ = error.maxCoeff();
      coefficients_ = fitted;
    }
    weights = weights.cwiseProduct(error);
    weights /= weights.sum();
  }
}

double StressPolynomial::degrees(double s1, double s3) const {
  return monomials(s1, s3, lowest_).dot(coefficients_);
}

double stressDegrees(double s1, double s2, double s3) {
  const Eigen::Matrix3d stretch = Eigen::Vector3d(s1, s2, s3).asDiagonal();
  return kDegrees * localDistortion(stretch).rotationalStress;
}

double searchedStressDegrees(double s1, double s2, double s3) {
  // The largest angle between w and S w, cos = w . S w / |S w|; by symmetry an eighth of the sphere is
  // enough.
  const Eigen::Array3d stretch(s1, s2, s3);
  double smallestCosine = 1;
  for (int tilt = 0; tilt <= kDirections; ++tilt)
    for (int turn = 0; turn <= kDirections; ++turn) {
      const double theta = 0.5 * std::numbers::pi * tilt / kDirections,
                   phi = 0.5 * std::numbers::pi * turn / kDirections;
      const Eigen::Array3d way(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
      const Eigen::Array3d image = stretch * way;
      smallestCosine = std::min(smallestCosine, (way * image).sum() / image.matrix().norm());
    }
  return kDegrees * std::acos(std::clamp(smallestCosine, -1.0, 1.0));
}

} // namespace viscera::deformation
