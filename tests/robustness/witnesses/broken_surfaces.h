#pragma once

#include <functional>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "clouds.h"
#include "shapes.h"
#include "viscera/geometry/triangle_mesh.h"

/// Surfaces with defects.
namespace viscera::tests {

using geometry::TriangleMesh;

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto points = a.points.rows(), triangles = a.triangles.rows();
  a.points.conservativeResize(points + b.points.rows(), 3);
  a.points.bottomRows(b.points.rows()) = b.points;
  a.triangles.conservativeResize(triangles + b.triangles.rows(), 3);
  a.triangles.bottomRows(b.triangles.rows()) = b.triangles.array() + static_cast<std::int32_t>(points);
  return a;
}

inline TriangleMesh insideOut(TriangleMesh mesh) {
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return mesh;
}

/// The sphere without the triangles whose middle is within `radius` of a few points on it.
inline TriangleMesh withHoles() {
  TriangleMesh mesh = sphere(5, 30);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 middle = (mesh.points.row(mesh.triangles(t, 0)) + mesh.points.row(mesh.triangles(t, 1)) +
                         mesh.points.row(mesh.triangles(t, 2)))
                            .transpose() /
                        3;
    bool cut = false;
    for (const Vec3& hole : {Vec3(30, 0, 0), Vec3(0, 0, -30), Vec3(-17, 17, 17)})
      cut = cut || (middle - hole).norm() < 6;
    if (!cut)
      mesh.triangles.row(kept++) = mesh.triangles.row(t).eval();
  }
  mesh.triangles.conservativeResize(kept, 3);
  return mesh;
}

/// Repeated triangles, some the other way around, and triangles of no area.
inline TriangleMesh withUselessTriangles() {
  TriangleMesh mesh = sphere(4, 30);
  const auto triangles = mesh.triangles.rows();
  mesh.triangles.conservativeResize(triangles + 400, 3);
  for (Eigen::Index i = 0; i < 200; ++i) {
    mesh.triangles.row(triangles + i) = mesh.triangles.row(3 * i);
    if (i % 2 == 0)
      std::swap(mesh.triangles(triangles + i, 0), mesh.triangles(triangles + i, 1));
    const std::int32_t a = mesh.triangles(2 * i, 0), b = mesh.triangles(2 * i, 1);
    mesh.triangles.row(triangles + 200 + i) << a, b, (i % 2 == 0 ? a : b);
  }
  return mesh;
}

inline TriangleMesh withFlippedPatches() {
  TriangleMesh mesh = sphere(4, 30);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); t += t % 5 == 0 ? 3 : 7)
    std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
  return mesh;
}

/// A pentagonal bipyramid.
inline TriangleMesh tenTriangles() {
  TriangleMesh mesh;
  mesh.points.resize(7, 3);
  for (int i = 0; i < 5; ++i)
    mesh.points.row(i) << 20 * std::cos(2 * M_PI * i / 5), 20 * std::sin(2 * M_PI * i / 5), 0;
  mesh.points.row(5) << 0, 0, 25;
  mesh.points.row(6) << 0, 0, -25;
  mesh.triangles.resize(10, 3);
  for (int i = 0; i < 5; ++i) {
    mesh.triangles.row(2 * i) << i, (i + 1) % 5, 5;
    mesh.triangles.row(2 * i + 1) << (i + 1) % 5, i, 6;
  }
  return mesh;
}

/// 2,097,152 triangles.
inline TriangleMesh twoMillionTriangles() {
  TriangleMesh mesh = sphere(9, 30);
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i) // Not a perfect ball.
    mesh.points.row(i) *= 1 + 0.2 * std::sin(0.2 * mesh.points(i, 0));
  return mesh;
}

inline TriangleMesh withNan() {
  TriangleMesh mesh = sphere(3, 30);
  mesh.points(77, 1) = std::numeric_limits<double>::quiet_NaN();
  return mesh;
}

/// Triangles anywhere, at any angle.
inline TriangleMesh soup() {
  TriangleMesh mesh;
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(-30, 30), edge(-4, 4);
  mesh.points.resize(600, 3);
  mesh.triangles.resize(200, 3);
  for (std::int32_t t = 0; t < 200; ++t) {
    mesh.triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    mesh.points.row(3 * t) = drawPlace(place, random).transpose();
    for (int k = 1; k < 3; ++k)
      mesh.points.row(3 * t + k) = mesh.points.row(3 * t) + drawPlace(edge, random).transpose();
  }
  return mesh;
}

/// A flat sheet.
inline TriangleMesh sheet() {
  TriangleMesh mesh = sphere(3, 30);
  mesh.points.col(2).setZero();
  return mesh;
}

/// A sphere with a dent so deep that it comes out at the other side, and a tube through it.
inline TriangleMesh selfIntersecting() {
  TriangleMesh mesh = sphere(5, 30);
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    if (mesh.points(i, 2) > 27)
      mesh.points(i, 2) -= 30 * (mesh.points(i, 2) - 27);
  TriangleMesh tube = box(100, 9, 9);
  tube.points.rowwise() += Eigen::RowVector3d(-50.3, -4.4, -5.1);
  return joined(mesh, tube);
}

} // namespace viscera::tests
