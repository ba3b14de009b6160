#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "choice_parameter.h"
#include "mean_value/triangle_share.h"
#include "nspace/direction_solver.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

enum class Lift { one, norm };

const Parameter kLift =
    choiceParameter("k", "Amount added to each weight when a handle is inserted", {"one", "norm"});

class Increments {
public:
  Increments(const Points& handles, Lift lift)
      : lift_(lift), hull_(geometry::ConvexHull(handles).triangles()) {
    std::vector<bool> outer(static_cast<std::size_t>(handles.rows()), false);
    for (const auto corner : hull_.reshaped())
      outer[static_cast<std::size_t>(corner)] = true;
    for (Eigen::Index i = 0; i < handles.rows(); ++i)
      (outer[static_cast<std::size_t>(i)] ? first_ : inner_).push_back(i);
  }

  bool operator()(const HandleDirections& sight, Values& beta) const {
    for (Eigen::Index t = 0; t < hull_.rows(); ++t)
      addTriangleShare(sight.units, hull_.row(t), beta);
    std::vector<Eigen::Index> present = first_;
    Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero();
    const auto enter = [&](Eigen::Index handle) {
      outer += sight.units.row(handle).transpose() * sight.units.row(handle);
      sum += sight.units.row(handle).transpose();
    };
    for (const Eigen::Index handle : present)
      enter(handle);
    for (const Eigen::Index next : inner_) {
      const auto solver = outer.ldlt();
      // The balance that the newcomer breaks and the one that the lift breaks.
      const Vec3 own = -solver.solve(sight.units.row(next).transpose()), lifted = -solver.solve(sum);
      const double k = lift_ == Lift::one ? 1 : fixedLength(own, lifted);
      if (!(k > 0))
        return false;
      // beta_i += u_i.d + k for those present and beta_next = 1, with G d = -(u_next + k sum u_i), where G is
      // sum u_i u_i^T: what is added is balanced.
      const Vec3 d = own + k * lifted;
      for (const Eigen::Index handle : present)
        beta[handle] += sight.units.row(handle).dot(d) + k;
      beta[next] = 1;
      present.push_back(next);
      enter(next);
    }
    if (lift_ == Lift::norm)
      beta = beta.cwiseMax(0);
    return true;
  }

private:
  /// The smallest k > 0 with `|own + k lifted| = k`, or 0.
  static double fixedLength(const Vec3& own, const Vec3& lifted) {
    const double square = lifted.squaredNorm() - 1, half = own.dot(lifted), constant = own.squaredNorm();
    const double inside = half * half - square * constant;
    if (inside < 0)
      return 0;
    // Both roots without cancellation.
    const double larger = -(half + std::copysign(std::sqrt(inside), half));
    double smallest = 0;
    for (const double root : {square != 0 ? larger / square : 0, larger != 0 ? constant / larger : 0})
      if (root > 0 && (smallest == 0 || root < smallest))
        smallest = root;
    return smallest;
  }

  Lift lift_;
  Triangles hull_;
  std::vector<Eigen::Index> first_; ///< On the hull.
  std::vector<Eigen::Index> inner_; ///< In the order in which they are added.
};

} // namespace

/// Mean value coordinates of the handles on the convex hull, to which the inner handles are added one by one
/// (thesis 3.1.3): each adds a weight of one, and the earlier ones change by `q_i . d + k`, with the vector d
/// that keeps the balance. `k`: `one`, or `norm` for the length of d, which the thesis only proposes: no
/// number is then negative, but d solves a quadratic equation, and where it has no positive root the point
/// has no coordinates. O(triangles + inner handles x n) a point.
std::shared_ptr<const CoordinateSystem> incrementalApproach() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "incremental-approach",
          .name = "Incremental approach",
          .summary = "Mean value on the hull, inner handles added one by one; they may make some negative",
          .traits = {.interpolates = true, .everywhere = false},
          .parameters = {kLift}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<DirectionSolver>(
            handles.positions, Increments(handles.positions, chosen<Lift>(parameters, kLift)));
      });
}

} // namespace viscera::coordinates
