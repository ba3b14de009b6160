#include "viscera/geometry/signed_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "closest_point.h"
#include "viscera/core/error.h"

namespace viscera::geometry {
namespace {

constexpr int kLeafSize = 4;
/// Of the triangle's size: nearer to an edge or corner than that counts as on it.
constexpr double kOnEdge = 1e-9;

double angleAt(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
}

} // namespace

struct SignedDistance::Branch {
  Vec3 low, high;
  int begin = 0, end = 0; ///< In `order_`, of a leaf.
  int right = 0;          ///< Second child; the first follows its parent. 0 for a leaf.

  double distance2(const Vec3& p) const { return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm(); }
};

struct SignedDistance::Hit {
  int triangle = -1;
  Vec3 point = Vec3::Zero();
};

SignedDistance::SignedDistance(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
  const Eigen::Index count = mesh_->triangles.rows();
  if (count == 0)
    throw DataError("a surface without triangles has no inside", "surface");
  Points middles(count, 3);
  faceNormals_.resize(count, 3);
  vertexNormals_ = Points::Zero(mesh_->points.rows(), 3);
  std::map<std::pair<int, int>, Vec3> edges;
  for (Eigen::Index t = 0; t < count; ++t) {
    const std::array<Vec3, 3> p = cornersOf(mesh_->points, mesh_->triangles, t);
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    middles.row(t) = (p[0] + p[1] + p[2]).transpose() / 3;
    faceNormals_.row(t) = normal.transpose();
    for (int k = 0; k < 3; ++k) {
      const int a = mesh_->triangles(t, (k + 1) % 3);
      const int b = mesh_->triangles(t, (k + 2) % 3);
      const double angle = angleAt(p[static_cast<std::size_t>(k)], p[static_cast<std::size_t>((k + 1) % 3)],
                                   p[static_cast<std::size_t>((k + 2) % 3)]);
      // n_v = sum theta_t n_t with the triangles' angles at the vertex; at an edge both angles are pi, and
      // n_1 + n_2 has their direction.
      vertexNormals_.row(mesh_->triangles(t, k)) += angle * normal.transpose();
      edges.try_emplace(std::minmax(a, b), Vec3::Zero()).first->second += normal;
    }
  }
  edgeNormals_.reserve(static_cast<std::size_t>(3 * count));
  for (Eigen::Index t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k)
      edgeNormals_.push_back(
          edges.at(std::minmax(mesh_->triangles(t, (k + 1) % 3), mesh_->triangles(t, (k + 2) % 3))));
  order_.resize(static_cast<std::size_t>(count));
  std::iota(order_.begin(), order_.end(), 0);
  grow(0, static_cast<int>(count), middles);
}

SignedDistance::~SignedDistance() = default;

int SignedDistance::grow(int begin, int end, const Points& middles) {
  const auto index = static_cast<int>(branches_.size());
  Branch branch;
  branch.low.setConstant(std::numeric_limits<double>::infinity());
  branch.high = -branch.low;
  for (int i = begin; i < end; ++i)
    for (const Vec3& p : cornersOf(mesh_->points, mesh_->triangles, order_[static_cast<std::size_t>(i)])) {
      branch.low = branch.low.cwiseMin(p);
      branch.high = branch.high.cwiseMax(p);
    }
  branch.begin = begin;
  branch.end = end;
  branches_.push_back(branch);
  if (end - begin <= kLeafSize)
    return index;
  // Halves of as many triangles, cut across the longest side of the box.
  Eigen::Index axis = 0;
  (branch.high - branch.low).maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
    return std::pair(middles(a, axis), a) < std::pair(middles(b, axis), b);
  });
  grow(begin, middle, middles);
  const int right = grow(middle, end, middles);
  branches_[static_cast<std::size_t>(index)].right = right;
  return index;
}

SignedDistance::Hit SignedDistance::find(const Vec3& point) const {
  Hit best;
  double best2 = std::numeric_limits<double>::infinity();
  std::array<std::pair<int, double>, 128> stack; // Deeper than any median split of 2^31 triangles.
  std::size_t top = 0;
  stack[top++] = {0, branches_[0].distance2(point)};
  while (top > 0) {
    const auto [index, distance2] = stack[--top];
    if (distance2 >= best2)
      continue;
    const Branch& branch = branches_[static_cast<std::size_t>(index)];
    if (branch.right == 0) {
      for (int i = branch.begin; i < branch.end; ++i) {
        const int triangle = order_[static_cast<std::size_t>(i)];
        const auto [a, b, c] = cornersOf(mesh_->points, mesh_->triangles, triangle);
        const Vec3 near = closestPointOfTriangle(point, a, b, c);
        const double d2 = (near - point).squaredNorm();
        if (d2 < best2) {
          best2 = d2;
          best = {triangle, near};
        }
      }
      continue;
    }
    // The nearer child is taken from the stack first: what it finds rules out more of the other.
    const double left2 = branches_[static_cast<std::size_t>(index + 1)].distance2(point);
    const double right2 = branches_[static_cast<std::size_t>(branch.right)].distance2(point);
    const bool leftFirst = left2 <= right2;
    stack[top++] = leftFirst ? std::pair(branch.right, right2) : std::pair(index + 1, left2);
    stack[top++] = leftFirst ? std::pair(index + 1, left2) : std::pair(branch.right, right2);
  }
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
