#include "viscera/geometry/carried_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/cell_lists.h"

namespace viscera::geometry {
namespace {

constexpr Eigen::Index kFewestVertices = 4;
/// A point nearer to a vertex than this part of the size of all vertices is that vertex.
constexpr double kSamePlace = 1e-9;
/// The near vertices reach to this multiple of the distance of the twelfth nearest one.
constexpr std::size_t kNearest = 12;
constexpr double kNearReach = 1.6;
/// A coarse choice of all vertices, one in each cell of this part of their size, tells how the surroundings
/// move as a whole. It counts less, so that near vertices lead where there are some on all sides.
constexpr double kCoarsePart = 1.0 / 32;
constexpr double kCoarseWeight = 0.005;
/// How far the coarse choice reaches: in cells, and more by the distance to the nearest vertex.
constexpr double kCoarseReach = 2.5, kCoarseReachOfDistance = 2.5;
/// Keeps the equations solvable where all vertices lie in a plane.
constexpr double kRidge = 1e-9;
constexpr Eigen::Index kGrain = 64;

/// Vertices that can be found by their place.
class Lookup {
public:
  Lookup(const Points& vertices, std::vector<std::int32_t> chosen, double edge)
      : vertices_(vertices), chosen_(std::move(chosen)), cells_(boundsOf(vertices), edge) {
    cells_.fill(static_cast<Eigen::Index>(chosen_.size()), [&](Eigen::Index item) {
      const Vec3 at = vertices_.row(chosen_[static_cast<std::size_t>(item)]).transpose();
      return Bounds{at, at};
    });
  }

  double edge() const { return cells_.edge(); }
  std::size_t size() const { return chosen_.size(); }

  /// `visit(vertex, distance)` for all within `radius`.
  template <class Visit>
  void within(const Vec3& point, double radius, const Visit& visit) const {
    const auto low = cells_.cellOf((point.array() - radius).matrix());
    const auto high = cells_.cellOf((point.array() + radius).matrix());
    for (Eigen::Index z = low[2]; z <= high[2]; ++z)
      for (Eigen::Index y = low[1]; y <= high[1]; ++y)
        for (Eigen::Index x = low[0]; x <= high[0]; ++x)
          cells_.visit({x, y, z}, [&](std::int32_t item) {
            const std::int32_t vertex = chosen_[static_cast<std::size_t>(item)];
            const double distance = (vertices_.row(vertex).transpose() - point).norm();
            if (distance <= radius)
              visit(vertex, distance);
          });
  }

  /// The distances of the nearest vertices, ascending: `count` of them, or all when there are fewer.
  std::vector<double> nearest(const Vec3& point, std::size_t count) const {
    count = std::min(count, size());
    std::vector<double> distances;
    for (double radius = edge(); distances.size() < count; radius *= 2) {
      distances.clear();
      within(point, radius, [&](std::int32_t, double distance) { distances.push_back(distance); });
    }
    std::sort(distances.begin(), distances.end());
    distances.resize(count);
    return distances;
  }

private:
  const Points& vertices_;
  std::vector<std::int32_t> chosen_;
  CellLists cells_;
};

std::vector<std::int32_t> allOf(const Points& vertices) {
  std::vector<std::int32_t> all(static_cast<std::size_t>(vertices.rows()));
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<std::int32_t>(i);
  return all;
}

/// One vertex in each cell that has any.
std::vector<std::int32_t> coarseOf(const Points& vertices, double edge) {
  CellLists cells(boundsOf(vertices), edge);
  cells.fill(vertices.rows(), [&](Eigen::Index item) {
    const Vec3 at = vertices.row(item).transpose();
    return Bounds{at, at};
  });
  std::vector<std::int32_t> chosen;
  const auto size = cells.size();
  for (Eigen::Index z = 0; z < size[2]; ++z)
    for (Eigen::Index y = 0; y < size[1]; ++y)
      for (Eigen::Index x = 0; x < size[0]; ++x) {
        bool taken = false;
        cells.visit({x, y, z}, [&](std::int32_t item) {
          if (!std::exchange(taken, true))
            chosen.push_back(item);
        });
      }
  return chosen;
}

/// Wendland's function of compact support: 1 at 0, smooth, 0 from 1 on.
double bump(double part) {
  const double left = std::max(0.0, 1 - part);
  return left * left * left * left * (4 * part + 1);
}

struct Weighted {
  std::int32_t vertex = 0;
  double weight = 0;
};

/// Turns weights into those of moving least squares with linear terms at `point`.
void reproduceLinear(const Points& vertices, const Vec3& point, double scale, std::vector<Weighted>& list) {
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  const auto termsOf = [&](const Weighted& item) -> Eigen::Vector4d {
    const Vec3 away = (vertices.row(item.vertex).transpose() - point) / scale;
    return {1, away.x(), away.y(), away.z()};
  };
  for (const Weighted& item : list) {
    const Eigen::Vector4d terms = termsOf(item);
    moments += item.weight * terms * terms.transpose();
  }
  const double ridge = kRidge * moments.trace();
  for (int axis = 1; axis < 4; ++axis) // The constant has none, so that a common shift is followed exactly.
    moments(axis, axis) += ridge;
  const Eigen::Vector4d factors = moments.ldlt().solve(Eigen::Vector4d::Unit(0));
  for (Weighted& item : list)
    item.weight *= factors.dot(termsOf(item));
}

struct Carriers {
  const Points& vertices;
  Lookup all, coarse;
  double same;

  explicit Carriers(const Points& verticesIn)
      : vertices(verticesIn), all(vertices, allOf(vertices), cellEdge(boundsOf(vertices), vertices.rows())),
        coarse(vertices, coarseOf(vertices, coarseEdge(vertices)), coarseEdge(vertices)),
        same(kSamePlace * boundsOf(vertices).diagonal()) {}

  static double coarseEdge(const Points& vertices) {
    const double size = boundsOf(vertices).diagonal();
    return size > 0 ? kCoarsePart * size : 1;
  }

  std::vector<Weighted> weightsAt(const Vec3& point) const {
    const std::vector<double> near = all.nearest(point, kNearest);
    std::vector<Weighted> list;
    if (near.front() <= same) {
      all.within(point, same, [&](std::int32_t vertex, double) { list.push_back({vertex, 1}); });
      return {*std::min_element(list.begin(), list.end(),
                                [](const auto& a, const auto& b) { return a.vertex < b.vertex; })};
    }
    const double nearReach = kNearReach * near.back();
    const double coarseReach = kCoarseReach * coarse.edge() + kCoarseReachOfDistance * near.front();
    all.within(point, nearReach, [&](std::int32_t vertex, double distance) {
      list.push_back({vertex, bump(distance / nearReach)});
    });
    coarse.within(point, coarseReach, [&](std::int32_t vertex, double distance) {
      list.push_back({vertex, kCoarseWeight * bump(distance / coarseReach)});
    });
    reproduceLinear(vertices, point, coarseReach, list);
    return list;
  }
};

} // namespace

CarriedPoints::CarriedPoints(const Points& rest, const Points& carriers, Threads threads)
    : carriers_(carriers.rows()) {
  if (carriers.rows() < kFewestVertices)
    throw DataError(
        misuse("points need four vertices at least that carry them, there are %1", carriers.rows()),
        "surface");
  const Carriers around(carriers);
  std::vector<std::vector<Weighted>> lists(static_cast<std::size_t>(rest.rows()));
  parallelRanges(rest.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      lists[static_cast<std::size_t>(i)] = around.weightsAt(rest.row(i).transpose());
  });
  first_.assign(1, 0);
  for (const auto& list : lists) {
    for (const Weighted& item : list) {
      vertices_.push_back(item.vertex);
      weights_.push_back(item.weight);
    }
    first_.push_back(static_cast<std::int64_t>(vertices_.size()));
  }
}

void CarriedPoints::at(const Points& carriers, Points& out, Threads threads) const {
  if (carriers.rows() != carriers_)
    throw UsageError(misuse("%1 vertices carry the points, not %2", carriers_, carriers.rows()));
  out.resize(size(), 3);
  constexpr Eigen::Index kPointsAtOnce = 512;
  parallelRanges(size(), kPointsAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const auto from = static_cast<std::size_t>(first_[static_cast<std::size_t>(i)]);
      const auto to = static_cast<std::size_t>(first_[static_cast<std::size_t>(i) + 1]);
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (std::size_t k = from; k < to; ++k)
        sum += weights_[k] * carriers.row(vertices_[k]);
      out.row(i) = sum;
    }
  });
}

bool CarriedPoints::isVertex(Eigen::Index point) const {
  const auto i = static_cast<std::size_t>(point);
  return first_[i + 1] - first_[i] == 1;
}

} // namespace viscera::geometry
