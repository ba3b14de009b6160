#include "viscera/geometry/normals.h"

#include <cassert>

namespace viscera::geometry {
namespace {

constexpr Eigen::Index kNormalsAtOnce = 4096;

/// Twice the area times the unit normal, in single precision: normals only feed the screen.
inline Eigen::Vector3f scaledNormal(const Points& points, const std::int32_t* t) {
  const double* a = points.data() + 3 * t[0];
  const double* b = points.data() + 3 * t[1];
  const double* c = points.data() + 3 * t[2];
  const Eigen::Vector3f u(float(b[0] - a[0]), float(b[1] - a[1]), float(b[2] - a[2]));
  const Eigen::Vector3f v(float(c[0] - a[0]), float(c[1] - a[1]), float(c[2] - a[2]));
  return u.cross(v);
}

} // namespace

void vertexNormals(const Points& points, const Triangles& triangles, const VertexTriangles& around,
                   Normals& normals, Threads threads) {
  assert(around.first.size() == static_cast<std::size_t>(points.rows()) + 1);
  // Two passes: a triangle's normal serves three vertices, and gathering keeps the order of the sums fixed.
  Normals faces(triangles.rows(), 3);
  parallelRanges(triangles.rows(), kNormalsAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index t = begin; t < end; ++t)
      faces.row(t) = scaledNormal(points, triangles.data() + 3 * t).transpose();
  });
  normals.resize(points.rows(), 3);
  parallelRanges(points.rows(), kNormalsAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index v = begin; v < end; ++v) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (auto i = around.first[std::size_t(v)]; i < around.first[std::size_t(v) + 1]; ++i)
        sum += faces.row(around.items[std::size_t(i)]).transpose();
      const float length = sum.norm();
      if (length > 0)
        sum /= length;
      normals.row(v) = sum.transpose();
    }
  });
}

Normals vertexNormals(const TriangleMesh& mesh) {
  Normals normals;
  vertexNormals(mesh.points, mesh.triangles, vertexTriangles(mesh.points.rows(), mesh.triangles), normals);
  return normals;
}

} // namespace viscera::geometry
