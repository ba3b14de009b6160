#include "sphere/sphere_samples.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

using SphereTriangle = std::array<Vec3, 3>;

std::vector<SphereTriangle> icosahedron() {
  Points corners(12, 3);
  Eigen::Index next = 0;
  for (const double one : {-1.0, 1.0})
    for (const double golden : {-std::numbers::phi, std::numbers::phi}) {
      corners.row(next++) << 0, one, golden;
      corners.row(next++) << one, golden, 0;
      corners.row(next++) << golden, 0, one;
    }
  corners.rowwise().normalize();
  std::vector<SphereTriangle> triangles;
  const geometry::ConvexHull hull(corners);
  for (Eigen::Index t = 0; t < hull.triangles().rows(); ++t) {
    const auto items = hull.triangles().row(t);
    triangles.push_back({corners.row(items[0]).transpose(), corners.row(items[1]).transpose(),
                         corners.row(items[2]).transpose()});
  }
  return triangles;
}

/// The solid angle under which the centre of the unit sphere sees the triangle,
/// `tan(area / 2) = det(a, b, c) / (1 + a . b + b . c + c . a)` (Van Oosterom and Strackee 1983, doi
/// 10.1109/TBME.1983.325207).
double sphericalArea(const SphereTriangle& t) {
  return 2 * std::atan2(t[0].dot(t[1].cross(t[2])), 1 + t[0].dot(t[1]) + t[1].dot(t[2]) + t[2].dot(t[0]));
}

} // namespace

SphereSamples sphereSamples(int level) {
  std::vector<SphereTriangle> triangles = icosahedron();
  for (int i = 0; i < level; ++i) {
    std::vector<SphereTriangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  SphereSamples samples;
  samples.directions.resize(3, static_cast<Eigen::Index>(triangles.size()));
  samples.areas.resize(static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    samples.directions.col(static_cast<Eigen::Index>(i)) = (t[0] + t[1] + t[2]).normalized();
    samples.areas[static_cast<Eigen::Index>(i)] = sphericalArea(t);
  }
  return samples;
}

} // namespace viscera::coordinates
