#pragma once

#include <functional>
#include <optional>

#include "viscera/coordinates/handle_checks.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {

/// The handles as they are seen from a point: unit vectors (`n x Dim`) and distances, mm.
template <int Dim>
struct HandleDirectionsOf {
  PointsOf<Dim> units;
  Values distances;
};
using HandleDirections = HandleDirectionsOf<3>;

/// The handles seen from `point`, none of which lies there. For Dim = 2 and 3, as all below.
template <int Dim>
HandleDirectionsOf<Dim> directionsTo(const PointsOf<Dim>& handles,
                                     const Eigen::Matrix<double, Dim, 1>& point);

/// The space of all vectors of n numbers that balance the directions, `sum beta_i q_i = 0`: V-perpendicular
/// in the thesis (3.18), with its projection (annex A). Refers to the directions it was made from.
template <int Dim>
class BalancedSpace {
public:
  /// False from `valid` where the directions do not span space.
  explicit BalancedSpace(const PointsOf<Dim>& units);
  bool valid() const { return valid_; }
  /// The vector of the space that is nearest to `values`.
  Values project(const Values& values) const {
    return values - units_ * (inverse_ * (units_.transpose() * values));
  }
  /// The projection of the unit vector along `index`.
  Values projectAxis(Eigen::Index index) const;

private:
  const PointsOf<Dim>& units_;
  Eigen::Matrix<double, Dim, Dim> inverse_;
  bool valid_ = false;
};

/// Fills `beta` (n numbers, set to zero before) such that `sum beta_i q_i = 0`; false where there is no
/// answer.
template <int Dim>
using BalanceIn = std::function<bool(const HandleDirectionsOf<Dim>& sight, Values& beta)>;

/// Turns balanced numbers into coordinates: divides them by the distances (thesis 3.15) and by their sum.
/// False where weights of both signs cancel to rounding errors.
bool weigh(const Values& distances, Values& weights);

/// The point solver of systems that need balanced numbers over the directions. It handles points at a handle
/// and points outside the hull itself.
class DirectionSolver final : public PointSolver {
public:
  DirectionSolver(const Points& handles, BalanceIn<3> balance);
  bool solve(const Vec3& point, Values& weights) const override;

  /// The directions of the handles seen from a point inside the hull and at no handle; else empty.
  std::optional<HandleDirections> sightFrom(const Vec3& point) const;

private:
  /// The handle at which the point lies, or -1.
  Eigen::Index handleAt(const Vec3& point) const;

  Points handles_;
  geometry::ConvexHull hull_;
  BalanceIn<3> balance_;
};

/// The systems of this folder in the plane, each beside its three-dimensional form.
BalanceIn<2> planeDeterminants();
BalanceIn<2> planeGradient(Eigen::Index handles, const ParameterValues& parameters);
/// Throws `UsageError` for methods that depend on all points together.
BalanceIn<2> planeLagrange(const ParameterValues& parameters);
BalanceIn<2> planeWire(const ParameterValues& parameters);

} // namespace viscera::coordinates
