#include "viscera/geometry/signed_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "closest_point.h"
#include "edge_uses.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {
namespace {

constexpr int kLeafSize = 4;
/// Part of the triangle's size: nearer to an edge or corner than that counts as on it.
constexpr double kOnEdge = 1e-9;

double angleAt(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
}

} // namespace

SignedDistance::SignedDistance(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
  const Eigen::Index count = mesh_->triangles.rows();
  if (count == 0)
    throw DataError(misuse("a surface without triangles has no inside"), "surface");
  Points middles(count, 3);
  faceNormals_.resize(count, 3);
  vertexNormals_ = Points::Zero(mesh_->points.rows(), 3);
  for (Eigen::Index t = 0; t < count; ++t) {
    const std::array<Vec3, 3> p = cornersOf(mesh_->points, mesh_->triangles, t);
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    middles.row(t) = (p[0] + p[1] + p[2]).transpose() / 3;
    faceNormals_.row(t) = normal.transpose();
    for (int k = 0; k < 3; ++k) {
      const double angle = angleAt(p[static_cast<std::size_t>(k)], p[static_cast<std::size_t>((k + 1) % 3)],
                                   p[static_cast<std::size_t>((k + 2) % 3)]);
      // n_v = sum theta_t n_t with the triangles' angles at the vertex; at an edge both angles are pi, and
      // n_1 + n_2 has their direction.
      vertexNormals_.row(mesh_->triangles(t, k)) += angle * normal.transpose();
    }
  }
  edgeNormals_.resize(static_cast<std::size_t>(3 * count));
  forEachEdge(mesh_->triangles, [this](std::span<const EdgeUse> uses) {
    Vec3 sum = Vec3::Zero();
    for (const EdgeUse& use : uses)
      sum += faceNormals_.row(use.side / 3).transpose();
    for (const EdgeUse& use : uses) {
      const int triangle = use.side / 3, corner = use.side % 3;
      edgeNormals_[static_cast<std::size_t>(3 * triangle + (corner + 2) % 3)] = sum; // Opposite to its edge.
    }
  });
  grow(middles);
}

/// Halves of as many triangles, cut across the longest side of the box.
void SignedDistance::grow(const Points& middles) {
  const auto boxOf = [this](std::span<const int> triangles, Vec3& sides) {
    Bounds box{Vec3::Constant(std::numeric_limits<double>::infinity()),
               Vec3::Constant(-std::numeric_limits<double>::infinity())};
    for (const int triangle : triangles)
      for (const Vec3& p : cornersOf(mesh_->points, mesh_->triangles, triangle)) {
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
      }
    sides = box.high - box.low;
    return box;
  };
  boxes_ = MedianTree<Bounds>(static_cast<int>(middles.rows()), kLeafSize, boxOf,
                              [&middles](int a, int b, Eigen::Index axis) {
                                return std::pair(middles(a, axis), a) < std::pair(middles(b, axis), b);
                              });
}

SignedDistance::Hit SignedDistance::find(const Vec3& point) const {
  Hit best;
  double best2 = std::numeric_limits<double>::infinity();
  boxes_.searchNearestFirst(
      [&point](const Bounds& box) {
        return (box.low - point).cwiseMax(point - box.high).cwiseMax(0).squaredNorm();
      },
      [&best2](const Bounds&, double distance2) { return distance2 >= best2; },
      [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          const int triangle = boxes_.order()[static_cast<std::size_t>(i)];
          const auto [a, b, c] = cornersOf(mesh_->points, mesh_->triangles, triangle);
          const Vec3 near = closestPointOfTriangle(point, a, b, c);
          const double d2 = (near - point).squaredNorm();
          if (d2 < best2) {
            best2 = d2;
            best = {triangle, near};
          }
        }
      });
  return best;
}

Vec3 SignedDistance::pseudonormal(const Hit& hit) const {
  const std::array<Vec3, 3> p = cornersOf(mesh_->points, mesh_->triangles, hit.triangle);
  const double size = (p[1] - p[0]).norm() + (p[2] - p[0]).norm();
  for (int k = 0; k < 3; ++k)
    if ((hit.point - p[static_cast<std::size_t>(k)]).norm() <= kOnEdge * size)
      return vertexNormals_.row(mesh_->triangles(hit.triangle, k)).transpose();
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = p[static_cast<std::size_t>((k + 1) % 3)];
    const Vec3& b = p[static_cast<std::size_t>((k + 2) % 3)];
    if ((closestPointOfSegment(hit.point, a, b) - hit.point).norm() <= kOnEdge * size)
      return edgeNormals_[static_cast<std::size_t>(3 * hit.triangle + k)];
  }
  return faceNormals_.row(hit.triangle).transpose();
}

double SignedDistance::operator()(const Vec3& point) const {
  // d = sign((p - c) . n) |p - c|, with the nearest point c and the pseudonormal n there.
  const Hit hit = find(point);
  const Vec3 away = point - hit.point;
  return away.dot(pseudonormal(hit)) < 0 ? -away.norm() : away.norm();
}

Vec3 SignedDistance::nearest(const Vec3& point) const {
  return find(point).point;
}

} // namespace viscera::geometry
