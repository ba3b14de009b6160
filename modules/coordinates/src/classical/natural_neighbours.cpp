#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "same_place.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

/// A convex polyhedron around the origin that half spaces are cut from. What is close to a plane may fall on
/// either side of it: the volume changes by no more than rounding.
class ConvexCell {
public:
  /// The cube [-half, half]^3.
  explicit ConvexCell(double half);

  /// Keeps what has `normal . x <= offset`. True when anything was cut off. O(corners).
  bool cut(const Vec3& normal, double offset);

  bool empty() const { return faces_.size() < 4; }
  double volume() const;
  /// The largest coordinate of a corner, without sign.
  double reach() const;

private:
  using Face = std::vector<Vec3>;

  void close(std::vector<Vec3>& rim, const Vec3& normal);

  std::vector<Face> faces_; ///< Corners in order, counter-clockwise from outside.
};

ConvexCell::ConvexCell(double half) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-half, half}) {
      Face face;
      for (const auto& [u, v] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        Vec3 corner;
        corner[axis] = side;
        corner[(axis + 1) % 3] = u * half;
        corner[(axis + 2) % 3] = v * half;
        face.push_back(corner);
      }
      if (side < 0)
        std::reverse(face.begin(), face.end());
      faces_.push_back(std::move(face));
    }
}

bool ConvexCell::cut(const Vec3& normal, double offset) {
  bool touched = false;
  for (const Face& face : faces_)
    for (const Vec3& corner : face)
      touched = touched || normal.dot(corner) > offset;
  if (!touched)
    return false;
  std::vector<Vec3> rim;
  std::vector<Face> kept;
  Face piece;
  for (const Face& face : faces_) {
    piece.clear();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 &from = face[i], &to = face[(i + 1) % face.size()];
      const double begin = normal.dot(from) - offset, end = normal.dot(to) - offset;
      if (begin <= 0)
        piece.push_back(from);
      if ((begin <= 0) != (end <= 0)) {
        piece.push_back(from + begin / (begin - end) * (to - from));
        rim.push_back(piece.back());
      }
    }
    if (piece.size() >= 3)
      kept.push_back(piece);
  }
  faces_ = std::move(kept);
  close(rim, normal);
  return true;
}

/// The new face: the corners on the plane, in the order of their angles around their middle.
void ConvexCell::close(std::vector<Vec3>& rim, const Vec3& normal) {
  if (rim.size() < 3)
    return;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : rim)
    middle += corner;
  middle /= static_cast<double>(rim.size());
  const Vec3 x = normal.unitOrthogonal(), y = normal.normalized().cross(x);
  std::vector<std::pair<double, Vec3>> around;
  for (const Vec3& corner : rim)
    around.emplace_back(std::atan2(y.dot(corner - middle), x.dot(corner - middle)), corner);
  std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Face face;
  for (const auto& [angle, corner] : around)
    face.push_back(corner);
  faces_.push_back(std::move(face));
}

double ConvexCell::volume() const {
  if (empty())
    return 0;
  // V = 1/6 sum det(a - o, b - o, c - o) over the faces' triangles, for any o.
  const Vec3 apex = faces_[0][0]; // Near the cell: the origin may be far from what is left.
  double volume = 0;
  for (const Face& face : faces_)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      volume += (face[0] - apex).dot((face[i] - apex).cross(face[i + 1] - apex));
  return std::max(0.0, volume / 6);
}

double ConvexCell::reach() const {
  double reach = 0;
  for (const Face& face : faces_)
    for (const Vec3& corner : face)
      reach = std::max(reach, corner.cwiseAbs().maxCoeff());
  return reach;
}

/// Times the handles' size: the cells of points near the hull reach far beyond it. The first is enough for
/// most and costs fewer digits.
constexpr double kReaches[] = {1e2, 1e5};

class NaturalNeighbourSolver final : public PointSolver {
public:
  explicit NaturalNeighbourSolver(const Points& handles) : handles_(handles), hull_(handles) {}

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
    // The cell of the origin: |x|^2 <= |x - s_i|^2, and so s_i . x <= |s_i|^2 / 2.
    ConvexCell cell(reach);
    std::vector<Eigen::Index> neighbours; // And some whose cut was cut off again later: they take nothing.
    for (const Eigen::Index site : order)
      if (cell.cut(sites.row(site).transpose(), squares[site] / 2))
        neighbours.push_back(site);
    if (cell.reach() >= reach)
      return false;
    // What site i had of it before, |x - s_i|^2 <= |x - s_j|^2 for all j, which is (s_j - s_i) . x <=
    // (|s_j|^2 - |s_i|^2) / 2; a_i is this volume over their sum.
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

/// Sibson's natural neighbour coordinates (thesis 3.1.2, end; Sibson 1981; Boissonnat, Cazals 2001): the
/// shares of the point's Voronoi cell that it takes from the cells of the handles. Positive, local, smooth
/// but at the handles. Cells are cut from half spaces without geometric predicates, so that handles on one
/// sphere cause no problems. O(n + k^2) cuts a point with k natural neighbours.
std::shared_ptr<const CoordinateSystem> naturalNeighbours() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "natural-neighbours",
                        .name = "Natural neighbours",
                        .summary = "Sibson's coordinates: what a point takes from its neighbours' Voronoi "
                                   "cells; positive and local",
                        .traits = {.positive = true, .interpolates = true}},
      [](const HandleSet& handles, const ParameterValues&) {
        return std::make_unique<NaturalNeighbourSolver>(handles.positions);
      });
}

} // namespace viscera::coordinates
