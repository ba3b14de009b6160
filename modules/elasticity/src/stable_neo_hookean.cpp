#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "viscera/core/error.h"
#include "viscera/elasticity/least_energy.h"

namespace viscera::elasticity {
namespace {

using Mat3 = Eigen::Matrix3d;
using Vec9 = Eigen::Matrix<double, 9, 1>;
using RowMat3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// dJ/dF.
Mat3 cofactorMatrix(const Mat3& f) {
  Mat3 g;
  g << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
  return g;
}

/// The entries of a matrix in the order of a `Tangent`.
Vec9 inOrder(const Mat3& m) {
  const RowMat3 rows = m;
  return Eigen::Map<const Vec9>(rows.data());
}

/// `F = U diag(s) V^T` with rotations U and V; the least s is negative where F is folded.
struct SignedValues {
  Mat3 u, v;
  Eigen::Vector3d s;
  explicit SignedValues(const Mat3& f) {
    const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    u = svd.matrixU();
    v = svd.matrixV();
    for (Mat3* rotation : {&u, &v})
      if (rotation->determinant() < 0)
        rotation->col(2) *= -1;
    s = (u.transpose() * f * v).diagonal();
  }
};

} // namespace

StableNeoHookean::StableNeoHookean(double poisson) : ratio_(1 / (1 - 2 * poisson)) {
  // 1 + lambda / mu = 1 + 2 nu / (1 - 2 nu).
  if (!(poisson > 0 && poisson < 0.5))
    throw UsageError("Poisson's ratio has to be above 0 and below 0.5");
}

double StableNeoHookean::energy(const Mat3& f) const {
  const double growth = f.determinant() - 1;
  return 0.5 * (f.squaredNorm() - 3) - growth + 0.5 * ratio_ * growth * growth;
}

Mat3 StableNeoHookean::stress(const Mat3& f) const {
  return f + (ratio_ * (f.determinant() - 1) - 1) * cofactorMatrix(f);
}

Tangent StableNeoHookean::tangent(const Mat3& f) const {
  const Vec9 g = inOrder(cofactorMatrix(f));
  const double c = ratio_ * (f.determinant() - 1) - 1;
  Tangent h = Tangent::Identity() + ratio_ * g * g.transpose();
  // d^2 J: the derivative of the cofactor (i, J) by F(k, L) is e_ikm e_JLN F(m, N).
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int di = 1; di < 3; ++di)
        for (int dj = 1; dj < 3; ++dj) {
          const int k = (i + di) % 3, l = (j + dj) % 3, m = (i + 3 - di) % 3, n = (j + 3 - dj) % 3;
          h(3 * i + j, 3 * k + l) += (di == dj ? c : -c) * f(m, n);
        }
  return h;
}

Tangent StableNeoHookean::projectedTangent(const Mat3& f) const {
  const SignedValues svd(f);
  const Eigen::Vector3d& s = svd.s;
  const double growth = s.prod() - 1, c = ratio_ * growth - 1;
  Tangent h = Tangent::Zero();
  const auto add = [&h](double eigenvalue, const Mat3& eigenmatrix) {
    if (eigenvalue <= 0)
      return;
    const Vec9 q = inOrder(eigenmatrix);
    h += eigenvalue * q * q.transpose();
  };
  // Turns and shears in the plane of two axes, with the value of the third: 1 + c s and 1 - c s.
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Mat3 ij = svd.u.col(i) * svd.v.col(j).transpose(), ji = svd.u.col(j) * svd.v.col(i).transpose();
    add(1 + c * s[k], (ij - ji) / std::numbers::sqrt2);
    add(1 - c * s[k], (ij + ji) / std::numbers::sqrt2);
  }
  // Stretches along the axes: the second derivative by the three values.
  const Eigen::Vector3d g(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
  Mat3 stretches = Mat3::Identity() + ratio_ * g * g.transpose();
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    stretches(i, j) += c * s[k];
    stretches(j, i) += c * s[k];
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(stretches);
  for (int k = 0; k < 3; ++k)
    add(solver.eigenvalues()[k], svd.u * solver.eigenvectors().col(k).asDiagonal() * svd.v.transpose());
  return h;
}

} // namespace viscera::elasticity
