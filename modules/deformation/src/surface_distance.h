#pragma once

#include "viscera/core/parallel.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Distances of single points from a triangle surface. Immutable; may be asked from several threads.
class SurfaceDistance {
public:
  /// Keeps a reference to `mesh`. O(m).
  explicit SurfaceDistance(const geometry::TriangleMesh& mesh);

  /// Signed distance in mm: positive outside, by the side of the nearest triangle (of several equally near
  /// ones, the one that faces the point most). O(n + m), of which only triangles near the nearest vertex are
  /// looked at closely.
  double operator()(const Vec3& point) const;

private:
  const geometry::TriangleMesh& mesh_;
  double longestEdge_ = 0;
};

} // namespace viscera::deformation
