#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>

#include "viscera/geometry/triangle_mesh.h"

/// Makes tubes with a known centreline, for tests.
namespace viscera::tests {

/// A closed, outward tube around `center(t)` with radius `radius(t)`, t from 0 to 1; the radius is 0 at both
/// ends, where the tube is closed by a point.
inline geometry::TriangleMesh tube(const std::function<Vec3(double)>& center,
                                   const std::function<double(double)>& radius, int rings = 90,
                                   int around = 40) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(rings * around + 2, 3);
  constexpr double kStep = 1e-4;
  Vec3 u = (center(kStep) - center(0)).unitOrthogonal();
  for (int i = 0; i < rings; ++i) {
    const double t = (i + 1.0) / (rings + 1);
    const Vec3 tangent = (center(t + kStep) - center(t - kStep)).normalized();
    u = (u - u.dot(tangent) * tangent).normalized();
    const Vec3 v = tangent.cross(u);
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * (i % 2)) / around;
      mesh.points.row(i * around + k) =
          (center(t) + radius(t) * (std::cos(angle) * u + std::sin(angle) * v)).transpose();
    }
  }
  const int first = rings * around;
  const int last = first + 1;
  mesh.points.row(first) = center(0).transpose();
  mesh.points.row(last) = center(1).transpose();
  mesh.triangles.resize(2 * around * rings, 3);
  Eigen::Index t = 0;
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    mesh.triangles.row(t++) << first, next, k;
    mesh.triangles.row(t++) << last, first - around + k, first - around + next;
    for (int i = 0; i + 1 < rings; ++i) {
      const int a = i * around + k, b = i * around + next;
      const int c = a + around, d = b + around;
      if (i % 2 == 0) {
        mesh.triangles.row(t++) << a, b, c;
        mesh.triangles.row(t++) << b, d, c;
      } else {
        mesh.triangles.row(t++) << a, d, c;
        mesh.triangles.row(t++) << a, b, d;
      }
    }
  }
  return mesh;
}

/// A stomach: wide at the top, bent like a J, narrow at its outlet, about 290 mm long.
struct StomachTube {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 center(double t) const {
    // Down for 150 mm, then around a bend of 75 mm radius.
    const double s = 290 * t;
    const double turned = std::max(0.0, s - 150) / 75;
    const Vec3 place(75 * (1 - std::cos(turned)), 12 * std::sin(3 * t),
                     -std::min(s, 150.0) - 75 * std::sin(turned));
    return rotation * (scale * place) + shift;
  }
  double radius(double t) const {
    const double wide = 42 - 30 * t * t * (3 - 2 * t);
    const double top = std::min(1.0, t / 0.14);
    const double end = std::min(1.0, (1 - t) / 0.04);
    return scale * wide * std::sqrt(1 - (1 - top) * (1 - top)) * std::sqrt(1 - (1 - end) * (1 - end));
  }
  geometry::TriangleMesh mesh() const {
    return tube([this](double t) { return center(t); }, [this](double t) { return radius(t); });
  }
};

} // namespace viscera::tests
