#pragma once

#include <functional>
#include <vector>

#include "nspace/direction_solver.h"

namespace viscera::coordinates {

/// The target vectors of the least squares problem (thesis 3.3.1).
enum class Target { one, inverseDistance, closeness };

/// n numbers, none of them negative, for handles at these distances.
Values targetAt(Target target, const Values& distances);

/// Calls `visit` with all ascending subsets of {0 .. count - 1} of `size` members, in order, until it returns
/// false.
void forEachSubset(Eigen::Index count, Eigen::Index size,
                   const std::function<bool(const std::vector<Eigen::Index>&)>& visit);

/// The vector nearest to a target of those that balance the directions (thesis 3.21 to 3.28), with the
/// different ways to keep its numbers from being negative. For Dim = 2 and 3.
template <int Dim>
class LagrangeProblem {
public:
  LagrangeProblem(const HandleDirectionsOf<Dim>& sight, Values target);

  /// The largest number of the target, for tolerances.
  double scale() const { return target_.maxCoeff(); }
  /// The problem with `amount` added to the whole target.
  LagrangeProblem shifted(double amount) const;

  /// Solves in closed form with `dead` handles at zero; others may get negative. False where the others
  /// do not span space. O(n).
  bool solve(const std::vector<Eigen::Index>& dead, Values& beta) const;
  /// The quadratic programme with `beta >= 0` (3.25), to rounding. False where Newton's method does not end.
  bool solveExactly(Values& beta) const;
  /// The feasible choice with the fewest zeros, of several the nearest to the target; false when
  /// `mostChoices` are not enough.
  bool solveByFewestZeros(int mostChoices, Values& beta) const;
  /// Negative ones become zero and the rest is solved again, until none is left.
  bool solveByDropping(Values& beta) const;

private:
  using Vector = Eigen::Matrix<double, Dim, 1>;
  using Matrix = Eigen::Matrix<double, Dim, Dim>;

  PointsOf<Dim> units_;
  Values target_;
  Matrix outer_; ///< `sum q q^T`
  Vector pull_;  ///< `sum u q`
};

} // namespace viscera::coordinates
