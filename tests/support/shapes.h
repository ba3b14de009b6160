#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "viscera/geometry/triangle_mesh.h"

/// Surfaces with known properties, for tests.
namespace viscera::tests {

/// An outward tetrahedron with corners 0, x, y, z: volume xyz / 6.
inline geometry::TriangleMesh tetrahedron(double x = 1, double y = 1, double z = 1) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points << 0, 0, 0, x, 0, 0, 0, y, 0, 0, 0, z;
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return mesh;
}

/// An outward box [0, x] x [0, y] x [0, z] of twelve triangles.
inline geometry::TriangleMesh box(double x = 1, double y = 1, double z = 1) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(8, 3);
  for (int i = 0; i < 8; ++i)
    mesh.points.row(i) << ((i & 1) ? x : 0), ((i & 2) ? y : 0), ((i & 4) ? z : 0);
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2,
      1, 3, 7, 1, 7, 5;
  return mesh;
}

/// An outward sphere: an octahedron subdivided `levels` times, 8 * 4^levels triangles.
inline geometry::TriangleMesh sphere(int levels, double radius = 1, const Vec3& center = Vec3::Zero()) {
  std::vector<Vec3> points = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                              -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  std::vector<Eigen::Vector3i> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                            {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (fresh)
        points.push_back((points[std::size_t(a)] + points[std::size_t(b)]).normalized());
      return entry->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const auto& t : triangles) {
      const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
    }
    triangles = std::move(finer);
  }
  geometry::TriangleMesh mesh;
  mesh.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.points.row(static_cast<Eigen::Index>(i)) = (center + radius * points[i]).transpose();
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i].transpose();
  return mesh;
}

} // namespace viscera::tests
