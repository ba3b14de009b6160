#include "viscera/deformation/least_stress.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace viscera::deformation {
namespace {

/// Part of the mean diagonal of Q: what a millimetre of any handle costs.
constexpr double kDisplacementShare = 1e-3;
/// Witnesses whose contributions are summed together; the sums are added in a fixed order.
constexpr Eigen::Index kSummedWitnesses = 64;
constexpr int kMostHalvings = 6;
/// A collapsed witness has no scale of its own.
constexpr double kSmallestScale = 1e-3;

using Mat3 = Eigen::Matrix3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// The deviator of the symmetric part as six numbers whose squares add up to its squared norm.
Vec6 deviator(const Mat3& m) {
  // dev sym M; each off-diagonal (M_ij + M_ji) / 2 counts twice in the norm, which the factor sqrt(2) does
  // for the one that is kept.
  const double mean = m.trace() / 3;
  const double half = 1 / std::numbers::sqrt2;
  Vec6 d;
  d << m(0, 0) - mean, m(1, 1) - mean, m(2, 2) - mean, half * (m(0, 1) + m(1, 0)), half * (m(1, 2) + m(2, 1)),
      half * (m(2, 0) + m(0, 2));
  return d;
}

/// The nearest rotation of a deformation gradient, also of a folded one, and the mean stretch.
struct Polar {
  Mat3 rotation;
  double scale;
  explicit Polar(const Mat3& m) {
    // M = U diag(s) V^T has the nearest rotation U V^T; of a folded M the one with the column of the smallest
    // s turned around, which changes |M - R| least. The scale is tr S / 3 = tr(R^T M) / 3.
    const Eigen::JacobiSVD<Mat3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    rotation = svd.matrixU() * svd.matrixV().transpose();
    if (rotation.determinant() < 0) {
      Mat3 u = svd.matrixU();
      u.col(2) *= -1;
      rotation = u * svd.matrixV().transpose();
    }
    scale = std::max((rotation.transpose() * m).trace() / 3, kSmallestScale);
  }
};

Points spread(const Values& motion, const std::vector<int>& free, Eigen::Index handles) {
  Points points = Points::Zero(handles, 3);
  for (std::size_t i = 0; i < free.size(); ++i)
    points.row(free[i]) = motion.segment<3>(3 * static_cast<Eigen::Index>(i)).transpose();
  return points;
}

Values gathered(const Points& gradient, const std::vector<int>& free) {
  Values values(3 * static_cast<Eigen::Index>(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i)
    values.segment<3>(3 * static_cast<Eigen::Index>(i)) = gradient.row(free[i]).transpose();
  return values;
}

} // namespace

/// `u^T Q u / 2 + c^T u` in the free handles' coordinates.
struct LeastStress::Quadratic {
  Eigen::MatrixXd q;
  Values c;
};

LeastStress::LeastStress(std::shared_ptr<const WitnessGradients> gradients, Eigen::Index witnesses,
                         Threads threads)
    : gradients_(std::move(gradients)), witnesses_(witnesses), threads_(threads) {
  assert(witnesses_ > 0 && witnesses_ <= gradients_->witnesses());
}

LeastStress::Quadratic LeastStress::quadratic(const Points& pose, const std::vector<int>& free) const {
  const auto size = 3 * static_cast<Eigen::Index>(free.size());
  const Eigen::Index portions = (witnesses_ + kSummedWitnesses - 1) / kSummedWitnesses;
  std::vector<Quadratic> sums(static_cast<std::size_t>(portions),
                              {Eigen::MatrixXd::Zero(size, size), Values::Zero(size)});
  parallelRanges(portions, 1, threads_, [&](Eigen::Index portion, Eigen::Index) {
    Quadratic& sum = sums[static_cast<std::size_t>(portion)];
    Eigen::Matrix<double, 6, Eigen::Dynamic> a(6, size);
    for (Eigen::Index w = portion * kSummedWitnesses;
         w < std::min(witnesses_, (portion + 1) * kSummedWitnesses); ++w) {
      if (gradients_->failed(w))
        continue;
      const Mat3 m = gradients_->deformationGradient(w, pose);
      const Polar polar(m);
      const Mat3 turned = polar.rotation.transpose() / polar.scale;
      // M(u) = M + sum_i u_i g_i^T with g_i = grad a_i. R and t = tr S / 3 held, dev sym(R^T M(u)) / t =
      // d + A u, where the column of handle i and axis k is dev sym(R^T e_k g_i^T) / t; |d + A u|^2 / 2 gives
      // Q = A^T A and c = A^T d.
      for (std::size_t i = 0; i < free.size(); ++i) {
        const Eigen::RowVector3d g = gradients_->gradient(w, free[i]).transpose();
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          a.col(3 * static_cast<Eigen::Index>(i) + axis) = deviator(turned.col(axis) * g);
      }
      sum.q.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
      sum.c += a.transpose() * deviator(turned * m);
    }
  });
  Quadratic total = std::move(sums.front());
  for (std::size_t portion = 1; portion < sums.size(); ++portion) {
    total.q += sums[portion].q;
    total.c += sums[portion].c;
  }
  total.q = total.q.selfadjointView<Eigen::Lower>();
  total.q.diagonal().array() += kDisplacementShare * total.q.trace() / static_cast<double>(size);
  return total;
}

Points LeastStress::direction(const Points& pose, const Points& gradient,
                              const std::vector<int>& free) const {
  // min u^T Q u / 2 under g . u = dV: u = dV Q^-1 g / (g . Q^-1 g), of which the direction is asked for.
  const Quadratic model = quadratic(pose, free);
  return spread(model.q.ldlt().solve(gathered(gradient, free)), free, pose.rows());
}

Points LeastStress::relaxation(const Points& pose, const Points& gradient,
                               const std::vector<int>& free) const {
  const Quadratic model = quadratic(pose, free);
  const auto solver = model.q.ldlt();
  const Values g = gathered(gradient, free);
  // min u^T Q u / 2 + c . u under g . u = 0: u = -Q^-1 c - l Q^-1 g with l = -(g . Q^-1 c) / (g . Q^-1 g).
  const Values down = -solver.solve(model.c), across = solver.solve(g);
  const double slope = g.dot(across);
  const Values motion = slope > 0 ? Values(down - g.dot(down) / slope * across) : down;
  // The rotations turn as the handles move: the quadratic model goes down, the real one does so nearby.
  const double before = cost(pose);
  for (double part = 1; part > std::ldexp(1.0, -kMostHalvings); part /= 2) {
    const Points step = spread(part * motion, free, pose.rows());
    if (step.allFinite() && cost(pose + step) < before)
      return step;
  }
  return Points::Zero(pose.rows(), 3);
}

double LeastStress::cost(const Points& pose) const {
  const Eigen::Index portions = (witnesses_ + kSummedWitnesses - 1) / kSummedWitnesses;
  Values sums = Values::Zero(portions);
  parallelRanges(portions, 1, threads_, [&](Eigen::Index portion, Eigen::Index) {
    for (Eigen::Index w = portion * kSummedWitnesses;
         w < std::min(witnesses_, (portion + 1) * kSummedWitnesses); ++w) {
      if (gradients_->failed(w))
        continue;
      const Mat3 m = gradients_->deformationGradient(w, pose);
      const Polar polar(m);
      sums[portion] += deviator(polar.rotation.transpose() * m / polar.scale).squaredNorm();
    }
  });
  return sums.sum() / static_cast<double>(witnesses_);
}

} // namespace viscera::deformation
