#include "nspace/direction_solver.h"

#include <utility>

#include <Eigen/LU>

#include "same_place.h"

namespace viscera::coordinates {
namespace {

/// Directions whose outer products have a smaller determinant do not span space.
constexpr double kFlatDirections = 1e-14;

} // namespace

template <int Dim>
HandleDirectionsOf<Dim> directionsTo(const PointsOf<Dim>& handles,
                                     const Eigen::Matrix<double, Dim, 1>& point) {
  HandleDirectionsOf<Dim> sight;
  sight.units = handles.rowwise() - point.transpose();
  sight.distances = sight.units.rowwise().norm();
  sight.units.array().colwise() /= sight.distances.array();
  return sight;
}

template HandleDirectionsOf<2> directionsTo<2>(const PointsOf<2>&, const Eigen::Vector2d&);
template HandleDirectionsOf<3> directionsTo<3>(const PointsOf<3>&, const Eigen::Vector3d&);

template <int Dim>
BalancedSpace<Dim>::BalancedSpace(const PointsOf<Dim>& units) : units_(units) {
  const Eigen::Matrix<double, Dim, Dim> outer = units.transpose() * units;
  double determinant = 0;
  outer.computeInverseAndDetWithCheck(inverse_, determinant, valid_, kFlatDirections);
}

template <int Dim>
Values BalancedSpace<Dim>::projectAxis(Eigen::Index index) const {
  // Projection of the axis e_k onto { beta : U^T beta = 0 }: e_k - U (U^T U)^-1 u_k.
  Values projected = -units_ * (inverse_ * units_.row(index).transpose());
  projected[index] += 1;
  return projected;
}

template class BalancedSpace<2>;
template class BalancedSpace<3>;

bool weigh(const Values& distances, Values& weights) {
  // a_i = (beta_i / r_i) / sum_j (beta_j / r_j): with sum beta_i u_i = 0 and u_i = (v_i - p) / r_i also
  // sum a_i (v_i - p) = 0.
  weights.array() /= distances.array();
  const double sum = weights.sum();
  if (!(sum > kSamePlace * weights.cwiseAbs().sum()))
    return false;
  weights /= sum;
  return true;
}

DirectionSolver::DirectionSolver(const Points& handles, BalanceIn<3> balance)
    : handles_(handles), hull_(handles), balance_(std::move(balance)) {}

Eigen::Index DirectionSolver::handleAt(const Vec3& point) const {
  Eigen::Index nearest = 0;
  const double distance = (handles_.rowwise() - point.transpose()).rowwise().norm().minCoeff(&nearest);
  return distance <= kSamePlace * hull_.diagonal() ? nearest : -1;
}

std::optional<HandleDirections> DirectionSolver::sightFrom(const Vec3& point) const {
  if (handleAt(point) >= 0 || !(hull_.signedDistance(point) < 0))
    return std::nullopt;
  return directionsTo<3>(handles_, point);
}

bool DirectionSolver::solve(const Vec3& point, Values& weights) const {
  if (const Eigen::Index handle = handleAt(point); handle >= 0) {
    weights[handle] = 1;
    return true;
  }
  const auto sight = sightFrom(point);
  return sight && balance_(*sight, weights) && weigh(sight->distances, weights);
}

} // namespace viscera::coordinates
