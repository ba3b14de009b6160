#include "surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscera::deformation {
namespace {

/// Of the nearest distance: triangles that share the nearest edge or vertex differ by rounding only.
constexpr double kTie = 1e-9;

struct Triangle {
  Vec3 a, b, c;
};

Triangle triangle(const geometry::TriangleMesh& mesh, Eigen::Index index) {
  const auto corner = [&](int k) -> Vec3 { return mesh.points.row(mesh.triangles(index, k)).transpose(); };
  return {corner(0), corner(1), corner(2)};
}

Vec3 nearestOnSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double length2 = (b - a).squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
  return a + t * (b - a);
}

/// Inside the triangle's prism it is the projection, elsewhere on the nearest edge.
Vec3 nearestOnTriangle(const Triangle& t, const Vec3& normal, const Vec3& p) {
  const double length2 = normal.squaredNorm();
  const bool inside = length2 > 0 && (t.b - t.a).cross(p - t.a).dot(normal) >= 0 &&
                      (t.c - t.b).cross(p - t.b).dot(normal) >= 0 &&
                      (t.a - t.c).cross(p - t.c).dot(normal) >= 0;
  if (inside)
    return p - (p - t.a).dot(normal) / length2 * normal;
  Vec3 nearest = nearestOnSegment(t.a, t.b, p);
  for (const Vec3& other : {nearestOnSegment(t.b, t.c, p), nearestOnSegment(t.c, t.a, p)})
    if ((other - p).squaredNorm() < (nearest - p).squaredNorm())
      nearest = other;
  return nearest;
}

} // namespace

SurfaceDistance::SurfaceDistance(const geometry::TriangleMesh& mesh) : mesh_(mesh) {
  double longest2 = 0;
  for (Eigen::Index index = 0; index < mesh.triangles.rows(); ++index) {
    const auto [a, b, c] = triangle(mesh, index);
    longest2 = std::max({longest2, (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }
  longestEdge_ = std::sqrt(longest2);
}

double SurfaceDistance::operator()(const Vec3& point) const {
  const Values distances2 = (mesh_.points.rowwise() - point.transpose()).rowwise().squaredNorm();
  double nearestCorner2 = std::numeric_limits<double>::infinity();
  for (Eigen::Index index = 0; index < mesh_.triangles.rows(); ++index)
    nearestCorner2 = std::min(nearestCorner2, distances2[mesh_.triangles(index, 0)]);
  // The nearest triangle is no farther than the nearest corner, and its own first corner at most an edge
  // beyond that.
  const double reach = std::sqrt(nearestCorner2) + longestEdge_;
  double nearest = std::numeric_limits<double>::infinity(), facing = 0;
  for (Eigen::Index index = 0; index < mesh_.triangles.rows(); ++index) {
    if (distances2[mesh_.triangles(index, 0)] > reach * reach)
      continue;
    const Triangle t = triangle(mesh_, index);
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    const Vec3 offset = point - nearestOnTriangle(t, normal, point);
    const double distance = offset.norm();
    const double side = offset.dot(normal.stableNormalized());
    if (distance > nearest * (1 + kTie))
      continue;
    const bool tie = distance >= nearest * (1 - kTie);
    if (!tie || std::abs(side) > std::abs(facing))
      facing = side;
    nearest = std::min(nearest, distance);
  }
  return facing < 0 ? -nearest : nearest;
}

} // namespace viscera::deformation
