#include "viscera/geometry/convex_polytope.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "closest_point.h"
#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::geometry {
namespace {

/// The points with those left out that lie within `tolerance` of an earlier one.
Points withoutRepeats(const Points& points, double tolerance) {
  std::vector<Vec3> kept;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 p = points.row(i).transpose();
    if (std::none_of(kept.begin(), kept.end(), [&](const Vec3& k) { return (k - p).norm() <= tolerance; }))
      kept.push_back(p);
  }
  return pointsOf(kept);
}

/// Corners of the convex hull of points in a plane, counter-clockwise (Andrew's monotone chain).
std::vector<int> hullInPlane(const Eigen::Matrix<double, Eigen::Dynamic, 2>& p, double tolerance) {
  std::vector<int> order(static_cast<std::size_t>(p.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return p(a, 0) != p(b, 0) ? p(a, 0) < p(b, 0) : p(a, 1) < p(b, 1); });
  const auto turnsLeft = [&](int a, int b, int c) {
    const Eigen::RowVector2d u = p.row(b) - p.row(a), v = p.row(c) - p.row(a);
    return u[0] * v[1] - u[1] * v[0] > tolerance * v.norm();
  };
  std::vector<int> hull;
  const auto walk = [&](auto begin, auto end) {
    const std::size_t floor = hull.size() + 1;
    for (auto i = begin; i != end; ++i) {
      while (hull.size() > floor && !turnsLeft(hull[hull.size() - 2], hull.back(), *i))
        hull.pop_back();
      hull.push_back(*i);
    }
    hull.pop_back();
  };
  walk(order.begin(), order.end());
  walk(order.rbegin(), order.rend());
  return hull;
}

} // namespace

ConvexPolytope ConvexPolytope::hullOf(const Points& all, double tolerance) {
  assert(all.rows() > 0 && all.allFinite() && tolerance > 0);
  ConvexPolytope polytope;
  polytope.tolerance_ = tolerance;
  const Points points = withoutRepeats(all, tolerance);
  const Points centered = points.rowwise() - points.colwise().mean();
  // The principal axes, by the eigenvectors of sum (p - m)(p - m)^T: how far the points reach along them
  // tells whether they fill space, a plane or a line.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centered.transpose() * centered);
  const Eigen::Matrix3d axes = solver.eigenvectors(); // Ascending: the last column is the longest direction.
  const Vec3 extent = (centered * axes).cwiseAbs().colwise().maxCoeff().transpose();
  polytope.box_ = boundsOf(points);
  if (extent[0] > tolerance && polytope.makeSolid(points))
    return polytope;
  if (extent[1] > tolerance)
    polytope.makePolygon(points, axes);
  else if (extent[2] > tolerance)
    polytope.makeSegment(points, axes);
  else
    polytope.makePoint(points);
  return polytope;
}

bool ConvexPolytope::makeSolid(const Points& points) {
  try {
    const ConvexHull hull(points);
    dimension_ = 3;
    vertices_ = points;
    triangles_ = hull.triangles();
    for (Eigen::Index f = 0; f < hull.planes().rows(); ++f)
      planes_.push_back(hull.planes().row(f).transpose());
    for (Eigen::Index t = 0; t < triangles_.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        if (triangles_(t, k) < triangles_(t, (k + 1) % 3))
          edges_.push_back({triangles_(t, k), triangles_(t, (k + 1) % 3)});
    return true;
  } catch (const DataError&) {
    return false; // Thinner than Qhull can tell from flat.
  }
}

void ConvexPolytope::addSlab(const Vec3& normal) {
  const double offset = normal.dot(vertices_.colwise().mean().transpose());
  planes_.emplace_back(normal[0], normal[1], normal[2], -offset);
  planes_.emplace_back(-normal[0], -normal[1], -normal[2], offset);
}

void ConvexPolytope::makePolygon(const Points& points, const Eigen::Matrix3d& axes) {
  dimension_ = 2;
  const Eigen::Matrix<double, Eigen::Dynamic, 2> flat = points * axes.rightCols<2>();
  const std::vector<int> corners = hullInPlane(flat, tolerance_);
  const int count = static_cast<int>(corners.size());
  vertices_.resize(count, 3);
  for (int i = 0; i < count; ++i)
    vertices_.row(i) = points.row(corners[static_cast<std::size_t>(i)]);
  const Vec3 normal = axes.col(1).cross(axes.col(2)); // The corners run counter-clockwise around it.
  addSlab(normal);
  triangles_.resize(std::max(0, count - 2), 3);
  for (int i = 0; i < count; ++i) {
    const Vec3 a = vertices_.row(i).transpose(), b = vertices_.row((i + 1) % count).transpose();
    const Vec3 outward = (b - a).cross(normal).normalized();
    planes_.emplace_back(outward[0], outward[1], outward[2], -outward.dot(a));
    edges_.push_back({i, (i + 1) % count});
    if (i >= 2)
      triangles_.row(i - 2) << 0, i - 1, i;
  }
}

void ConvexPolytope::makeSegment(const Points& points, const Eigen::Matrix3d& axes) {
  dimension_ = 1;
  const Vec3 direction = axes.col(2);
  const Values along = points * direction;
  Eigen::Index low = 0, high = 0;
  along.minCoeff(&low);
  along.maxCoeff(&high);
  vertices_.resize(2, 3);
  vertices_ << points.row(low), points.row(high);
  edges_ = {{0, 1}};
  addSlab(axes.col(0));
  addSlab(axes.col(1));
  planes_.emplace_back(direction[0], direction[1], direction[2], -along[high]);
  planes_.emplace_back(-direction[0], -direction[1], -direction[2], along[low]);
}

void ConvexPolytope::makePoint(const Points& points) {
  dimension_ = 0;
  vertices_ = points.colwise().mean();
  edges_ = {{0, 0}};
  for (int k = 0; k < 3; ++k)
    addSlab(Vec3::Unit(k));
}

double ConvexPolytope::signedDistance(const Vec3& point) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& plane : planes_)
    largest = std::max(largest, plane.head<3>().dot(point) + plane[3]);
  return largest;
}

Vec3 ConvexPolytope::closestPoint(const Vec3& point) const {
  if (contains(point))
    return point;
  Vec3 best = vertices_.row(0).transpose();
  const auto consider = [&](const Vec3& candidate) {
    if ((candidate - point).squaredNorm() < (best - point).squaredNorm())
      best = candidate;
  };
  const auto vertex = [&](int i) -> Vec3 { return vertices_.row(i).transpose(); };
  for (Eigen::Index t = 0; t < triangles_.rows(); ++t)
    consider(closestPointOfTriangle(point, vertex(triangles_(t, 0)), vertex(triangles_(t, 1)),
                                    vertex(triangles_(t, 2))));
  if (triangles_.rows() == 0)
    for (const auto& [a, b] : edges_)
      consider(closestPointOfSegment(point, vertex(a), vertex(b)));
  return best;
}

/// The ends of those parts of this set's edges that lie in `by`.
void ConvexPolytope::clippedEdges(const ConvexPolytope& by, std::vector<Vec3>& ends) const {
  const double slack = std::max(tolerance_, by.tolerance_);
  for (const auto& [from, to] : edges_) {
    const Vec3 a = vertices_.row(from).transpose(), b = vertices_.row(to).transpose();
    double low = 0, high = 1;
    for (const auto& plane : by.planes_) {
      const double atA = plane.head<3>().dot(a) + plane[3] - slack,
                   atB = plane.head<3>().dot(b) + plane[3] - slack;
      // h(a + t (b - a)) = h_a + t (h_b - h_a) = 0 at t = h_a / (h_a - h_b), h the height above a plane;
      // inside is h <= 0.
      if (atA > 0 && atB > 0)
        low = 2;
      else if (atA > 0)
        low = std::max(low, atA / (atA - atB));
      else if (atB > 0)
        high = std::min(high, atA / (atA - atB));
    }
    if (low > high)
      continue;
    ends.emplace_back(a + low * (b - a));
    ends.emplace_back(a + high * (b - a));
  }
}

std::optional<ConvexPolytope> ConvexPolytope::intersection(const ConvexPolytope& other) const {
  // Most pairs of many sets are far apart, which their boxes show at once.
  const double apart = 4 * std::max(tolerance_, other.tolerance_);
  if ((box_.low.array() > other.box_.high.array() + apart).any() ||
      (other.box_.low.array() > box_.high.array() + apart).any())
    return std::nullopt;
  // Every corner of the common set is an end of an edge of one, cut off by the other.
  std::vector<Vec3> corners;
  clippedEdges(other, corners);
  other.clippedEdges(*this, corners);
  if (corners.empty())
    return std::nullopt;
  // Cutting with slack leaves corners of one place up to a few tolerances apart.
  return hullOf(pointsOf(corners), apart);
}

} // namespace viscera::geometry
