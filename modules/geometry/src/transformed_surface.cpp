#include "viscera/geometry/transformed_surface.h"

namespace viscera::geometry {
namespace {

/// Subtracted from zero, so that 0 does not become -0.
template <class Columns>
void negate(Columns&& columns) {
  columns = (0.0 - columns.array()).matrix().eval();
}

} // namespace

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
