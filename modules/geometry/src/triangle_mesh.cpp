#include "viscera/geometry/triangle_mesh.h"

#include <string>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::geometry {
namespace {

/// Subtracted from zero, so that 0 does not become -0.
template <class Columns>
void negate(Columns&& columns) {
  columns = (0.0 - columns.array()).matrix().eval();
}

} // namespace

VertexTriangles vertexTriangles(Eigen::Index vertexCount, const Triangles& triangles) {
  VertexTriangles around;
  around.first.assign(static_cast<std::size_t>(vertexCount) + 1, 0);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      ++around.first[static_cast<std::size_t>(triangles(t, k)) + 1];
  for (std::size_t v = 1; v < around.first.size(); ++v)
    around.first[v] += around.first[v - 1];

  around.items.resize(static_cast<std::size_t>(triangles.size()));
  std::vector<std::int32_t> next(around.first.begin(), around.first.end() - 1);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      auto& slot = next[static_cast<std::size_t>(triangles(t, k))];
      around.items[static_cast<std::size_t>(slot++)] = static_cast<std::int32_t>(t);
    }
  return around;
}

void requireValid(const TriangleMesh& mesh, const Text& where) {
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    if (!mesh.points.row(v).allFinite())
      throw DataError(diagnostic("vertex %1 has a coordinate that is not a finite number", v), where,
                      "export the surface again");
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.triangles(t, k) < 0 || mesh.triangles(t, k) >= mesh.points.rows())
        throw DataError(diagnostic("triangle %1 refers to vertex %2, but there are %3", t,
                                   mesh.triangles(t, k), mesh.points.rows()),
                        where, "export the surface again");
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  mesh.points *= factor;
  return mesh;
}

TriangleMesh turnedHalf(TriangleMesh mesh) {
  negate(mesh.points.leftCols<2>());
  return mesh;
}

TriangleMesh mirrored(TriangleMesh mesh) {
  negate(mesh.points.leftCols<1>());
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return mesh;
}

} // namespace viscera::geometry
