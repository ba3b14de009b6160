#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"

/// A thick-walled cylinder that twists, inflates and shortens without changing its volume, with its strain in
/// closed form.
namespace viscera::tests {

/// Around the z axis: the annulus at z = 0, the apex at z = `length`, in front is +x.
struct ThickCylinder {
  double inner = 20, outer = 32, length = 90;
};

/// `r = sqrt(a^2 + (R^2 - A^2) / lambda)`, `theta = Theta + twist Z`, `z = lambda Z`: isochoric for any inner
/// radius a.
struct CylinderMotion {
  ThickCylinder rest;
  double innerNow = 20;  ///< a
  double shortening = 1; ///< lambda
  double twistPerMm = 0; ///< rad a mm of Z

  double radiusAt(double radius) const {
    return std::sqrt(innerNow * innerNow + (radius * radius - rest.inner * rest.inner) / shortening);
  }
  Vec3 operator()(const Vec3& point) const {
    const double radius = std::hypot(point.x(), point.y()), r = radiusAt(radius);
    const double angle = std::atan2(point.y(), point.x()) + twistPerMm * point.z();
    return {r * std::cos(angle), r * std::sin(angle), shortening * point.z()};
  }
  Points operator()(const Points& points) const {
    Points moved(points.rows(), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      moved.row(i) = (*this)(Vec3(points.row(i))).transpose();
    return moved;
  }
  /// The deformation gradient in closed form.
  Eigen::Matrix3d gradientAt(const Vec3& point) const {
    const double radius = std::hypot(point.x(), point.y()), r = radiusAt(radius);
    const double before = std::atan2(point.y(), point.x()), after = before + twistPerMm * point.z();
    const auto frame = [](double angle) {
      Eigen::Matrix3d axes;
      axes << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
      return axes;
    };
    Eigen::Matrix3d local = Eigen::Matrix3d::Zero(); // Rows and columns: radial, around, along.
    local(0, 0) = radius / (shortening * r);
    local(1, 1) = r / radius;
    local(1, 2) = r * twistPerMm;
    local(2, 2) = shortening;
    return frame(after) * local * frame(before).transpose();
  }
  double radialStrain(double radius) const {
    return 0.5 * (std::pow(radius / (shortening * radiusAt(radius)), 2) - 1);
  }
  double aroundStrain(double radius) const { return 0.5 * (std::pow(radiusAt(radius) / radius, 2) - 1); }
  double alongStrain(double radius) const {
    const double turn = radiusAt(radius) * twistPerMm;
    return 0.5 * (shortening * shortening + turn * turn - 1);
  }
  /// Between z, downward, and the direction in which the angle grows.
  double shearStrain(double radius) const {
    return 0.5 * radiusAt(radius) * radiusAt(radius) / radius * twistPerMm;
  }
};

/// A closed tube's surface: wall, and a flat fan at both ends around its middle.
inline geometry::TriangleMesh closedTube(double radius, double from, double to, int around, int along) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(around * (along + 1) + 2, 3);
  for (int k = 0; k <= along; ++k)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      mesh.points.row(k * around + i) << radius * std::cos(angle), radius * std::sin(angle),
          from + (to - from) * k / along;
    }
  const int low = around * (along + 1), high = low + 1;
  mesh.points.row(low) << 0, 0, from;
  mesh.points.row(high) << 0, 0, to;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    for (int k = 0; k < along; ++k) {
      const int a = k * around + i, b = k * around + j, c = a + around, d = b + around;
      triangles.insert(triangles.end(), {{a, b, c}, {b, d, c}});
    }
    triangles.push_back({low, j, i});
    triangles.push_back({high, along * around + i, along * around + j});
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
  return mesh;
}

/// The wall as tetrahedra, six a brick; points on the boundary come last, as in a witness mesh.
inline deformation::WitnessMesh tubeWall(const ThickCylinder& tube, int around, int across, int along) {
  const auto grid = [&](int i, int j, int k) { return (k * (across + 1) + j) * around + i % around; };
  std::vector<int> row(static_cast<std::size_t>(around * (across + 1) * (along + 1)));
  deformation::WitnessMesh mesh;
  mesh.points.resize(static_cast<Eigen::Index>(row.size()), 3);
  Eigen::Index next = 0;
  for (const bool inside : {true, false}) {
    for (int k = 0; k <= along; ++k)
      for (int j = 0; j <= across; ++j)
        for (int i = 0; i < around; ++i) {
          if ((j > 0 && j < across && k > 0 && k < along) != inside)
            continue;
          const double angle = 2 * std::numbers::pi * i / around;
          const double radius = tube.inner + (tube.outer - tube.inner) * j / across;
          row[static_cast<std::size_t>(grid(i, j, k))] = static_cast<int>(next);
          mesh.points.row(next++) << radius * std::cos(angle), radius * std::sin(angle),
              tube.length * k / along;
        }
    if (inside)
      mesh.witnesses = next;
  }
  static constexpr int kPaths[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                       {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  std::vector<std::array<std::int32_t, 4>> cells;
  for (int k = 0; k < along; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < around; ++i)
        for (const auto& path : kPaths) {
          std::array<std::int32_t, 4> cell{};
          for (std::size_t c = 0; c < 4; ++c)
            cell[c] = row[static_cast<std::size_t>(
                grid(i + (path[c] & 1), j + (path[c] >> 1 & 1), k + (path[c] >> 2 & 1)))];
          const Vec3 a = mesh.points.row(cell[0]), b = mesh.points.row(cell[1]), d = mesh.points.row(cell[2]),
                     e = mesh.points.row(cell[3]);
          if ((b - a).cross(d - a).dot(e - a) < 0)
            std::swap(cell[1], cell[2]);
          cells.push_back(cell);
        }
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(cells.size()), 4);
  for (std::size_t t = 0; t < cells.size(); ++t)
    for (int c = 0; c < 4; ++c)
      mesh.tetrahedra(static_cast<Eigen::Index>(t), c) = cells[t][static_cast<std::size_t>(c)];
  return mesh;
}

/// A ventricle: half of a prolate spheroid of those half axes, closed at z = 0 by a fan, apex at z = `depth`.
inline geometry::TriangleMesh ventricle(double radius, double depth, const Vec3& middle = Vec3::Zero(),
                                        int around = 48, int along = 40) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(around * along + 2, 3);
  for (int k = 0; k < along; ++k) {
    const double height = std::sin(0.5 * std::numbers::pi * k / along);
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around, r = radius * std::sqrt(1 - height * height);
      mesh.points.row(k * around + i) =
          (middle + Vec3(r * std::cos(angle), r * std::sin(angle), depth * height)).transpose();
    }
  }
  const int base = around * along, apex = base + 1;
  mesh.points.row(base) = middle.transpose();
  mesh.points.row(apex) = (middle + Vec3(0, 0, depth)).transpose();
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    triangles.push_back({base, j, i});
    for (int k = 0; k + 1 < along; ++k) {
      const int a = k * around + i, b = k * around + j, c = a + around, d = b + around;
      triangles.insert(triangles.end(), {{a, b, c}, {b, d, c}});
    }
    triangles.push_back({apex, (along - 1) * around + i, (along - 1) * around + j});
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
  return mesh;
}

} // namespace viscera::tests
