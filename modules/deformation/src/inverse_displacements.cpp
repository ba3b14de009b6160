#include "viscera/deformation/inverse_displacements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "broyden_search.h"
#include "rest_field.h"
#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

constexpr Eigen::Index kBoundAtOnce = 20'000; ///< Points bound at a time: weights take memory.
constexpr int kMostInverseRounds = 40;
constexpr double kAccuracy = 1e-3; ///< Of the spacing.

/// The displacement of any point of the rest space.
class Motion {
public:
  Motion(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
         const Points& pose, const coordinates::BindOptions& options)
      : system_(system), handles_(handles), pose_(pose), options_(options), hull_(handles.positions),
        middle_(boundsOf(handles.positions).center()) {
    // The middle of the box may lie outside a lopsided hull; the mean of the handles never does.
    if (hull_.signedDistance(middle_) > -kWithinHull * hull_.diagonal())
      middle_ = handles.positions.colwise().mean().transpose();
  }

  /// `n x 3`; rows of points without coordinates are not finite.
  Points operator()(const Points& points) const {
    Points inside = points;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      inside.row(i) = pulledIn(points.row(i).transpose()).transpose();
    Progress quiet; // The caller reports, and looks for cancelling between chunks.
    const auto binding = system_.bind(handles_, inside, options_, quiet);
    Points moved;
    binding->deform(pose_, moved, options_.threads);
    moved -= inside;
    for (const int failure : binding->report().failures)
      moved.row(failure).setConstant(std::numeric_limits<double>::quiet_NaN());
    return moved;
  }

private:
  Vec3 pulledIn(const Vec3& point) const {
    const auto& planes = hull_.planes();
    const Vec3 way = point - middle_;
    double part = 1;
    for (Eigen::Index f = 0; f < planes.rows(); ++f) {
      const Vec3 normal = planes.row(f).head<3>().transpose();
      // n . (m + t way) + offset <= -margin: t is at most room / (n . way) where the way leads towards the
      // plane.
      const double room = -(normal.dot(middle_) + planes(f, 3)) - kWithinHull * hull_.diagonal();
      const double wanted = normal.dot(way);
      if (wanted > room)
        part = std::min(part, std::max(room, 0.0) / wanted);
    }
    return middle_ + part * way;
  }

  const coordinates::CoordinateSystem& system_;
  const coordinates::HandleSet& handles_;
  const Points& pose_;
  const coordinates::BindOptions& options_;
  geometry::ConvexHull hull_;
  Vec3 middle_;
};

void solve(std::vector<BroydenSearch> searches, const Motion& motion, DisplacementGrid& grid) {
  const double accuracy = kAccuracy * grid.spacing;
  const auto finish = [&](const BroydenSearch& search) {
    if (search.bestError <= accuracy)
      grid.largestErrorMm = std::max(grid.largestErrorMm, search.bestError);
    else
      ++grid.unreached;
    if (std::isfinite(search.bestError)) // Else it stays zero.
      grid.vectors.row(search.row) = (search.best - search.target).transpose();
  };
  for (int round = 0; round < kMostInverseRounds && !searches.empty(); ++round) {
    std::vector<Vec3> places;
    for (const BroydenSearch& search : searches)
      places.push_back(search.at);
    const Points moved = motion(pointsOf(places));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < searches.size(); ++i) {
      if (searches[i].advance(moved.row(static_cast<Eigen::Index>(i)).transpose(), accuracy))
        searches[kept++] = searches[i];
      else
        finish(searches[i]);
    }
    searches.resize(kept);
  }
  for (const BroydenSearch& search : searches)
    finish(search);
}

DisplacementGrid emptyGrid(const GridOptions& options) {
  if (!(options.spacing > 0))
    throw UsageError("It has to be positive", "spacing");
  DisplacementGrid grid;
  grid.origin = options.box.low;
  grid.spacing = options.spacing;
  const Vec3 cells = ((options.box.high - options.box.low) / options.spacing).array().ceil().max(1);
  if ((cells.array() + 1).prod() > kMostGridPoints)
    throw UsageError("The displacement field would have more than 20 million points", "spacing",
                     "take a larger one");
  grid.size = cells.cast<int>().array() + 1;
  grid.vectors.setZero(Eigen::Index(grid.size[0]) * grid.size[1] * grid.size[2], 3);
  return grid;
}

} // namespace

GridOptions gridAround(const Points& rest, const Points& posed, double spacing) {
  const Bounds a = boundsOf(rest), b = boundsOf(posed);
  const Vec3 room = Vec3::Constant(2 * spacing);
  return {{a.low.cwiseMin(b.low) - room, a.high.cwiseMax(b.high) + room}, spacing};
}

Vec3 DisplacementGrid::point(Eigen::Index row) const {
  const Eigen::Index x = row % size[0], y = row / size[0] % size[1], z = row / size[0] / size[1];
  return origin + spacing * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

DisplacementGrid inverseDisplacements(const coordinates::CoordinateSystem& system,
                                      const coordinates::HandleSet& handles, const Points& pose,
                                      const coordinates::BindOptions& options, const GridOptions& gridOptions,
                                      Progress& progress) {
  DisplacementGrid grid = emptyGrid(gridOptions);
  const Motion motion(system, handles, pose, options);
  for (Eigen::Index begin = 0; begin < grid.vectors.rows(); begin += kBoundAtOnce) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(begin) / static_cast<double>(grid.vectors.rows()),
                    "Tracing the displacement field");
    const Eigen::Index end = std::min(begin + kBoundAtOnce, grid.vectors.rows());
    std::vector<BroydenSearch> searches(static_cast<std::size_t>(end - begin));
    for (Eigen::Index row = begin; row < end; ++row) {
      BroydenSearch& search = searches[static_cast<std::size_t>(row - begin)];
      search.row = row;
      search.target = grid.point(row);
      search.at = search.target;
    }
    solve(std::move(searches), motion, grid);
  }
  progress.report(1);
  return grid;
}

} // namespace viscera::deformation
