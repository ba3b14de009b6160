#pragma once

#include "viscera/coordinates/handle_checks.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {

/// The handles as they are seen from a point: unit vectors (`n x Dim`) and distances, mm.
template <int Dim>
struct SightIn {
  PointsOf<Dim> units;
  Values distances;
};
using Sight = SightIn<3>;

/// The handles seen from `point`, none of which lies there. For Dim = 2 and 3, as all below.
template <int Dim>
SightIn<Dim> sightOf(const PointsOf<Dim>& handles, const Eigen::Matrix<double, Dim, 1>& point);

/// The space of all vectors of n numbers that balance the directions, `sum beta_i q_i = 0`: what the thesis
/// calls V-perpendicular (3.18), with its projection (annex A). Refers to the directions it was made from.
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

/// Systems that ask for balanced numbers over the directions and divide them by the distances (thesis 3.15):
/// a point at a handle and a point outside the hull are dealt with here.
class DirectionSolver : public PointSolver {
public:
  explicit DirectionSolver(const Points& handles);
  bool solve(const Vec3& point, Values& weights) const final;

  const Points& handles() const { return handles_; }
  /// No coordinates exist at points that are not inside.
  bool inside(const Vec3& point) const { return hull_.signedDistance(point) < 0; }
  /// The handle at which the point lies, or -1.
  Eigen::Index handleAt(const Vec3& point) const;

protected:
  /// Fills `beta` (n numbers, set to zero before) such that `sum beta_i q_i = 0`; false where there is no
  /// answer.
  virtual bool balance(const Sight& sight, Values& beta) const = 0;

private:
  Points handles_;
  geometry::ConvexHull hull_;
};

} // namespace viscera::coordinates
