#include "viscera/geometry/winding_number.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

namespace viscera::geometry {
namespace {

constexpr std::int32_t kLeafTriangles = 4;
/// A node is seen as one dipole from this many of its radii away; the error falls with the square.
constexpr double kFar = 2.5;
/// Halving 2^31 triangles down to one takes fewer levels, and each level leaves one node on the stack.
constexpr int kDeepest = 64;

struct TriangleCorners {
  Vec3 a, b, c;
  Vec3 areaNormal() const { return 0.5 * (b - a).cross(c - a); }
  Vec3 center() const { return (a + b + c) / 3; }
};

/// The solid angle of a triangle seen from `p`, divided by 4 pi (Van Oosterom and Strackee 1983,
/// doi:10.1109/TBME.1983.325207). Positive from behind, that is from inside.
double solidAnglePart(const TriangleCorners& triangle, const Vec3& p) {
  const Vec3 a = triangle.a - p, b = triangle.b - p, c = triangle.c - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double above = a.dot(b.cross(c));
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return std::atan2(above, below) / (2 * std::numbers::pi);
}

} // namespace

struct WindingNumber::Tree {
  struct Node {
    Vec3 center = Vec3::Zero(); ///< Weighted by area.
    Vec3 normal = Vec3::Zero(); ///< Sum of the area normals.
    double radius = 0;
    std::int32_t begin = 0, end = 0; ///< Its triangles.
    std::int32_t second = -1;        ///< The second child; the first follows its parent. -1: a leaf.
  };
  std::vector<TriangleCorners> triangles;
  std::vector<Node> nodes;

  explicit Tree(const TriangleMesh& mesh) {
    triangles.reserve(static_cast<std::size_t>(mesh.triangles.rows()));
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      const auto [a, b, c] = cornersOf(mesh.points, mesh.triangles, t);
      triangles.push_back({a, b, c});
    }
    if (!triangles.empty())
      build(0, static_cast<std::int32_t>(triangles.size()));
  }

  std::int32_t build(std::int32_t begin, std::int32_t end) {
    const auto index = static_cast<std::int32_t>(nodes.size());
    nodes.emplace_back();
    const Bounds box = summarise(nodes.back(), begin, end);
    if (end - begin <= kLeafTriangles)
      return index;
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const std::int32_t middle = begin + (end - begin) / 2;
    std::nth_element(triangles.begin() + begin, triangles.begin() + middle, triangles.begin() + end,
                     [axis](const TriangleCorners& x, const TriangleCorners& y) {
                       return x.a[axis] + x.b[axis] + x.c[axis] < y.a[axis] + y.b[axis] + y.c[axis];
                     });
    build(begin, middle);
    const std::int32_t second = build(middle, end);
    nodes[static_cast<std::size_t>(index)].second = second;
    return index;
  }

  /// Fills the sums of a node; returns the box of its triangles' centres.
  Bounds summarise(Node& node, std::int32_t begin, std::int32_t end) const {
    node.begin = begin;
    node.end = end;
    double area = 0;
    Bounds box{triangles[std::size_t(begin)].center(), triangles[std::size_t(begin)].center()};
    for (std::int32_t t = begin; t < end; ++t) {
      const TriangleCorners& triangle = triangles[static_cast<std::size_t>(t)];
      const Vec3 normal = triangle.areaNormal(), center = triangle.center();
      node.normal += normal;
      node.center += normal.norm() * center;
      area += normal.norm();
      box = {box.low.cwiseMin(center), box.high.cwiseMax(center)};
    }
    node.center = area > 0 ? Vec3(node.center / area) : box.center();
    for (std::int32_t t = begin; t < end; ++t)
      for (const Vec3& corner :
           {triangles[std::size_t(t)].a, triangles[std::size_t(t)].b, triangles[std::size_t(t)].c})
        node.radius = std::max(node.radius, (corner - node.center).norm());
    return box;
  }
};

WindingNumber::WindingNumber(const TriangleMesh& mesh) : tree_(std::make_unique<const Tree>(mesh)) {}
WindingNumber::~WindingNumber() = default;
WindingNumber::WindingNumber(WindingNumber&&) noexcept = default;
WindingNumber& WindingNumber::operator=(WindingNumber&&) noexcept = default;

double WindingNumber::operator()(const Vec3& point) const {
  if (tree_->nodes.empty())
    return 0;
  double sum = 0;
  std::int32_t waiting[kDeepest] = {0};
  for (int count = 1; count > 0;) {
    const std::int32_t index = waiting[--count];
    const Tree::Node& node = tree_->nodes[static_cast<std::size_t>(index)];
    const Vec3 offset = node.center - point;
    const double squared = offset.squaredNorm();
    // w = 1 / (4 pi) int n . (x - p) / |x - p|^3 dA; from far away A . (c - p) / (4 pi |c - p|^3), with A the
    // sum of the triangles' area vectors and c their centroid.
    if (squared > kFar * kFar * node.radius * node.radius) {
      sum += offset.dot(node.normal) / (4 * std::numbers::pi * squared * std::sqrt(squared));
    } else if (node.second < 0) {
      for (std::int32_t t = node.begin; t < node.end; ++t)
        sum += solidAnglePart(tree_->triangles[static_cast<std::size_t>(t)], point);
    } else {
      waiting[count++] = node.second;
      waiting[count++] = index + 1;
    }
  }
  return sum;
}

} // namespace viscera::geometry
