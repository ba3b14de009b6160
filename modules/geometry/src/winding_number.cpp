#include "viscera/geometry/winding_number.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "viscera/geometry/median_tree.h"

namespace viscera::geometry {
namespace {

constexpr int kLeafTriangles = 4;
/// A branch is seen as one dipole from this many of its radii away; the error falls with the square.
constexpr double kFar = 2.5;

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
  /// A branch's triangles, seen as one dipole.
  struct Dipole {
    Vec3 center = Vec3::Zero(); ///< Weighted by area.
    Vec3 normal = Vec3::Zero(); ///< Sum of the area normals.
    double radius = 0;
  };
  std::vector<TriangleCorners> triangles; ///< In the order of the leaves.
  MedianTree<Dipole> dipoles;

  explicit Tree(const TriangleMesh& mesh) {
    std::vector<TriangleCorners> given;
    given.reserve(static_cast<std::size_t>(mesh.triangles.rows()));
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      const auto [a, b, c] = cornersOf(mesh.points, mesh.triangles, t);
      given.push_back({a, b, c});
    }
    const auto along = [&given](int t, Eigen::Index axis) {
      const TriangleCorners& triangle = given[static_cast<std::size_t>(t)];
      return triangle.a[axis] + triangle.b[axis] + triangle.c[axis];
    };
    dipoles = MedianTree<Dipole>(
        static_cast<int>(given.size()), kLeafTriangles,
        [&given](std::span<const int> items, Vec3& sides) { return dipoleOf(given, items, sides); },
        [&along](int a, int b, Eigen::Index axis) { return along(a, axis) < along(b, axis); });
    triangles.reserve(given.size());
    for (const int t : dipoles.order())
      triangles.push_back(given[static_cast<std::size_t>(t)]);
  }

  /// The sums of some triangles; `sides` are those of the box of their centres.
  static Dipole dipoleOf(const std::vector<TriangleCorners>& triangles, std::span<const int> items,
                         Vec3& sides) {
    Dipole dipole;
    double area = 0;
    const Vec3 first = triangles[static_cast<std::size_t>(items.front())].center();
    Bounds box{first, first};
    for (const int t : items) {
      const TriangleCorners& triangle = triangles[static_cast<std::size_t>(t)];
      const Vec3 normal = triangle.areaNormal(), center = triangle.center();
      dipole.normal += normal;
      dipole.center += normal.norm() * center;
      area += normal.norm();
      box = {box.low.cwiseMin(center), box.high.cwiseMax(center)};
    }
    dipole.center = area > 0 ? Vec3(dipole.center / area) : box.center();
    for (const int t : items) {
      const TriangleCorners& triangle = triangles[static_cast<std::size_t>(t)];
      for (const Vec3& corner : {triangle.a, triangle.b, triangle.c})
        dipole.radius = std::max(dipole.radius, (corner - dipole.center).norm());
    }
    sides = box.high - box.low;
    return dipole;
  }
};

WindingNumber::WindingNumber(const TriangleMesh& mesh) : tree_(std::make_unique<const Tree>(mesh)) {}
WindingNumber::~WindingNumber() = default;
WindingNumber::WindingNumber(WindingNumber&&) noexcept = default;
WindingNumber& WindingNumber::operator=(WindingNumber&&) noexcept = default;

double WindingNumber::operator()(const Vec3& point) const {
  double sum = 0;
  tree_->dipoles.walk(
      [&](const Tree::Dipole& dipole) {
        const Vec3 offset = dipole.center - point;
        const double squared = offset.squaredNorm();
        if (!(squared > kFar * kFar * dipole.radius * dipole.radius))
          return true;
        // w = 1 / (4 pi) int n . (x - p) / |x - p|^3 dA; from far away A . (c - p) / (4 pi |c - p|^3), with A
        // the sum of the triangles' area vectors and c their centroid.
        sum += offset.dot(dipole.normal) / (4 * std::numbers::pi * squared * std::sqrt(squared));
        return false;
      },
      [&](int begin, int end) {
        for (int t = begin; t < end; ++t)
          sum += solidAnglePart(tree_->triangles[static_cast<std::size_t>(t)], point);
      });
  return sum;
}

} // namespace viscera::geometry
