#include "viscera/coordinates/classical/natural_neighbours.h"

#include <algorithm>
#include <numeric>

#include "classical/convex_cell.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

/// Of the handles' size: a point this near to a handle is at it.
constexpr double kSamePlace = 1e-12;
/// Times the handles' size: the cells of points near the hull reach far beyond it. The first is enough for
/// most and costs fewer digits.
constexpr double kReaches[] = {1e2, 1e5};

class Solver final : public PointSolver {
public:
  explicit Solver(const Points& handles) : handles_(handles), hull_(handles) {}

  bool solve(const Vec3& point, Values& weights) const override {
    const Points sites = handles_.rowwise() - point.transpose();
    Eigen::Index nearest = 0;
    if (sites.rowwise().norm().minCoeff(&nearest) <= kSamePlace * hull_.diagonal()) {
      weights[nearest] = 1;
      return true;
    }
    if (!(hull_.signedDistance(point) < 0))
      return false;
    for (const double reach : kReaches)
      if (shareCell(sites, reach * hull_.diagonal(), weights))
        return true;
    return false;
  }

private:
  /// False when the cell of the point at the origin is not closed within `reach`.
  static bool shareCell(const Points& sites, double reach, Values& weights) {
    const Values squares = sites.rowwise().squaredNorm();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(sites.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
      return squares[a] != squares[b] ? squares[a] < squares[b] : a < b;
    });
    ConvexCell cell(reach);
    std::vector<Eigen::Index> neighbours; // And some whose cut was cut off again later: they take nothing.
    for (const Eigen::Index site : order)
      if (cell.cut(sites.row(site).transpose(), squares[site] / 2))
        neighbours.push_back(site);
    if (cell.reach() >= reach)
      return false;
    weights.setZero();
    for (const Eigen::Index own : neighbours) {
      ConvexCell taken = cell;
      for (const Eigen::Index other : neighbours)
        if (other != own && !taken.empty())
          taken.cut((sites.row(other) - sites.row(own)).transpose(), (squares[other] - squares[own]) / 2);
      weights[own] = taken.volume();
    }
    const double sum = weights.sum();
    if (!(sum > 0))
      return false;
    weights /= sum;
    return true;
  }

  Points handles_;
  geometry::ConvexHull hull_;
};

} // namespace

std::string NaturalNeighbours::summary() const {
  return "Sibson's coordinates: what a point takes from its neighbours' Voronoi cells; positive and local";
}

Traits NaturalNeighbours::traits() const {
  Traits traits;
  traits.positive = true;
  traits.interpolates = true;
  return traits;
}

std::vector<Parameter> NaturalNeighbours::parameters() const {
  return {};
}

std::unique_ptr<const PointSolver> NaturalNeighbours::prepare(const HandleSet& handles,
                                                              const ParameterValues&) const {
  return std::make_unique<Solver>(handles.positions);
}

} // namespace viscera::coordinates
