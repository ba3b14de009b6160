#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <utility>

#include "choice_parameter.h"
#include "nspace/direction_solver.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

enum class PointSet { axes, opposites, both };
enum class Connection { cycle, complete };

const Parameter kPoints =
    choiceParameter("points", "The points of n-space that the wire connects", {"p1", "p2", "p3"});
const Parameter kConnection =
    choiceParameter("connection", "Order in which the wire connects the points", {"cycle", "complete"});

/// Columns are the projected ends of the wire.
template <int Dim>
Eigen::MatrixXd wireEnds(Eigen::Index count, const BalancedSpace<Dim>& space, PointSet points) {
  Eigen::MatrixXd axes(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    axes.col(i) = space.projectAxis(i);
  if (points == PointSet::axes)
    return axes;
  if (points == PointSet::opposites) { // The projection P is linear: P (1 - e_i) = sum_k P e_k - P e_i.
    const Values ones = axes.rowwise().sum();
    return ones.replicate(1, count) - axes;
  }
  Eigen::MatrixXd both(count, 2 * count); // p1, p(n+1), p2, p(n+2), ...: a cycle as the thesis's C2.
  for (Eigen::Index i = 0; i < count; ++i) {
    both.col(2 * i) = axes.col(i);
    both.col(2 * i + 1) = -axes.col(i);
  }
  return both;
}

/// Adds the middle of the segment's positive part, times its length.
void addSegment(const Eigen::Ref<const Values>& from, const Eigen::Ref<const Values>& to, Values& beta) {
  // Number i is from_i + t (to_i - from_i): where its ends differ in sign it is zero at
  // t = from_i / (from_i - to_i), and positive on the side of its positive end.
  double begin = 0, end = 1;
  for (Eigen::Index i = 0; i < from.size() && begin < end; ++i) {
    if (from[i] < 0 && to[i] < 0)
      return;
    if (from[i] < 0)
      begin = std::max(begin, from[i] / (from[i] - to[i]));
    else if (to[i] < 0)
      end = std::min(end, from[i] / (from[i] - to[i]));
  }
  if (!(begin < end))
    return;
  // The integral along a straight piece is its length times its middle. The centroid is the sum of these
  // (thesis 3.3.2); what the thesis divides it by is a common factor.
  const double middle = (begin + end) / 2;
  beta += ((end - begin) * (to - from).norm()) * ((1 - middle) * from + middle * to);
}

template <int Dim>
BalanceIn<Dim> wire(const ParameterValues& parameters) {
  return [points = chosen<PointSet>(parameters, kPoints),
          connection = chosen<Connection>(parameters, kConnection)](const HandleDirectionsOf<Dim>& sight,
                                                                    Values& beta) {
    const BalancedSpace<Dim> space(sight.units);
    if (!space.valid())
      return false;
    const Eigen::MatrixXd ends = wireEnds(sight.distances.size(), space, points);
    const Eigen::Index count = ends.cols();
    for (Eigen::Index i = 0; i < count; ++i)
      if (connection == Connection::cycle)
        addSegment(ends.col(i), ends.col((i + 1) % count), beta);
      else
        for (Eigen::Index j = i + 1; j < count; ++j)
          addSegment(ends.col(i), ends.col(j), beta);
    beta = beta.cwiseMax(0); // Cut ends are zero but for rounding.
    return beta.maxCoeff() > 0;
  };
}

} // namespace

BalanceIn<2> planeWire(const ParameterValues& parameters) {
  return wire<2>(parameters);
}

/// Coordinates from a wire (a polygonal line) through the projections of fixed points of n-space onto the
/// balanced vectors, cut by the positive orthant; the mean of the remaining line, weighted by length (thesis
/// 3.3.2). `points`: `p1` the axes, `p2` all ones but one zero, `p3` the axes and their opposites.
/// `connection`: `cycle` (the thesis's C1, or C2 with `p3`) or `complete` (C3). The wire often misses the
/// orthant, and the point then has no coordinates. O(n^2), for the complete graph O(n^3) a point.
std::shared_ptr<const CoordinateSystem> wireApproach() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "wire-approach",
          .name = "Wire approach",
          .summary = "A wire in the space of balanced vectors; for many points it has no answer",
          .traits = {.positive = true, .interpolates = true, .everywhere = false, .smooth = false},
          .parameters = {kPoints, kConnection}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<DirectionSolver>(handles.positions, wire<3>(parameters));
      });
}

} // namespace viscera::coordinates
