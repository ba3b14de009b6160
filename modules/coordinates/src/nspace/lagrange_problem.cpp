#include "nspace/lagrange_problem.h"

#include <limits>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace viscera::coordinates {
namespace {

/// Directions whose outer products have a smaller determinant do not span space.
constexpr double kFlatProblem = 1e-12;
/// Part of the sum of the numbers: as well balanced as rounding allows.
constexpr double kBalanced = 1e-14;
constexpr int kMostLagrangeSteps = 200;
constexpr double kSufficientDecrease = 1e-4;
constexpr double kShortestStep = 1e-12;

} // namespace

Values targetAt(Target target, const Values& distances) {
  switch (target) {
  case Target::inverseDistance:
    return distances.cwiseInverse();
  case Target::closeness:
    return 1 - distances.array() / distances.maxCoeff();
  case Target::one:
    break;
  }
  return Values::Ones(distances.size());
}

void forEachSubset(Eigen::Index count, Eigen::Index size,
                   const std::function<bool(const std::vector<Eigen::Index>&)>& visit) {
  std::vector<Eigen::Index> members(static_cast<std::size_t>(size));
  for (Eigen::Index i = 0; i < size; ++i)
    members[static_cast<std::size_t>(i)] = i;
  while (visit(members)) {
    Eigen::Index last = size - 1; // The last member that can still move up.
    while (last >= 0 && members[static_cast<std::size_t>(last)] == count - size + last)
      --last;
    if (last < 0)
      return;
    Eigen::Index next = members[static_cast<std::size_t>(last)];
    for (Eigen::Index i = last; i < size; ++i)
      members[static_cast<std::size_t>(i)] = ++next;
  }
}

template <int Dim>
LagrangeProblem<Dim>::LagrangeProblem(const HandleDirectionsOf<Dim>& sight, Values target)
    : units_(sight.units), target_(std::move(target)), outer_(units_.transpose() * units_),
      pull_(units_.transpose() * target_) {}

template <int Dim>
LagrangeProblem<Dim> LagrangeProblem<Dim>::shifted(double amount) const {
  LagrangeProblem moved = *this;
  // U^T (t + a 1) = U^T t + a sum u_i.
  moved.target_.array() += amount;
  moved.pull_ += amount * units_.colwise().sum().transpose();
  return moved;
}

template <int Dim>
bool LagrangeProblem<Dim>::solve(const std::vector<Eigen::Index>& dead, Values& beta) const {
  Matrix outer = outer_;
  Vector pull = pull_;
  for (const Eigen::Index handle : dead) {
    outer -= units_.row(handle).transpose() * units_.row(handle);
    pull -= target_[handle] * units_.row(handle).transpose();
  }
  // sum (beta_i - t_i)^2 is least under sum beta_i u_i = 0 (thesis 3.21) where beta = t + U m, with m half
  // the Lagrange multipliers (3.23), and so U^T U m = -U^T t (3.24).
  Matrix inverse;
  double determinant = 0;
  bool invertible = false;
  outer.computeInverseAndDetWithCheck(inverse, determinant, invertible, kFlatProblem);
  if (!invertible)
    return false;
  // Among those that are not dead: beta = t - U (U^T U)^-1 U^T t.
  beta = target_ - units_ * (inverse * pull);
  for (const Eigen::Index handle : dead)
    beta[handle] = 0;
  return true;
}

template <int Dim>
bool LagrangeProblem<Dim>::solveExactly(Values& beta) const {
  Vector multipliers = Vector::Zero();
  // beta_i = max(0, t_i + u_i.m); the multipliers m minimise the dual |beta|^2 / 2, whose gradient is
  // sum beta_i u_i and whose Hessian is sum u_i u_i^T over beta_i > 0.
  const auto numbersAt = [&](const Vector& at) -> Values { return (target_ + units_ * at).cwiseMax(0); };
  for (int step = 0; step < kMostLagrangeSteps; ++step) {
    beta = numbersAt(multipliers);
    const Vector slope = units_.transpose() * beta;
    if (slope.norm() <= kBalanced * beta.sum())
      return beta.sum() > 0;
    Matrix bend = Matrix::Zero();
    for (Eigen::Index i = 0; i < beta.size(); ++i)
      if (beta[i] > 0)
        bend += units_.row(i).transpose() * units_.row(i);
    if (bend.determinant() < kFlatProblem)
      bend.diagonal().array() += 1e-3;
    const Vector way = -bend.ldlt().solve(slope);
    const double value = beta.squaredNorm() / 2;
    double length = 1;
    while (length > kShortestStep && numbersAt(multipliers + length * way).squaredNorm() / 2 >
                                         value + kSufficientDecrease * length * slope.dot(way))
      length /= 2;
    // So near to the end that the decrease is rounding: the full step is the right one.
    multipliers += (length > kShortestStep ? length : 1.0) * way;
  }
  const Vector slope = units_.transpose() * beta;
  return slope.norm() <= 100 * kBalanced * beta.sum();
}

template <int Dim>
bool LagrangeProblem<Dim>::solveByFewestZeros(int mostChoices, Values& beta) const {
  Values trial(target_.size());
  double nearest = std::numeric_limits<double>::infinity();
  int choices = 0;
  const double floor = -kFlatProblem * scale();
  for (Eigen::Index zeros = 0; zeros + Dim + 1 <= target_.size(); ++zeros) {
    forEachSubset(target_.size(), zeros, [&](const std::vector<Eigen::Index>& dead) {
      if (++choices > mostChoices)
        return false;
      if (!solve(dead, trial) || trial.minCoeff() < floor)
        return true;
      if (const double distance = (trial - target_).squaredNorm(); distance < nearest) {
        nearest = distance;
        beta = trial.cwiseMax(0);
      }
      return true;
    });
    if (choices > mostChoices)
      return false;
    if (nearest < std::numeric_limits<double>::infinity())
      return true;
  }
  return false;
}

template <int Dim>
bool LagrangeProblem<Dim>::solveByDropping(Values& beta) const {
  std::vector<Eigen::Index> dead;
  while (solve(dead, beta)) {
    const std::size_t before = dead.size();
    const double floor = -kFlatProblem * scale();
    for (Eigen::Index i = 0; i < beta.size(); ++i)
      if (beta[i] < floor)
        dead.push_back(i);
    if (dead.size() == before) {
      beta = beta.cwiseMax(0);
      return beta.maxCoeff() > 0;
    }
  }
  return false;
}

template class LagrangeProblem<2>;
template class LagrangeProblem<3>;

} // namespace viscera::coordinates
