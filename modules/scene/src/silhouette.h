#pragma once

#include <vector>

#include "viscera/geometry/normals.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::scene {

/// From where a surface is seen.
struct Eye {
  Vec3 position = Vec3::Zero(); ///< mm; for a perspective camera.
  Vec3 forward = Vec3::UnitY(); ///< Unit, direction of sight; for a parallel one.
  bool parallel = false;
};

/// Fills `segments` with the contour of a surface: six numbers a segment, two points in mm. It is the line in
/// which the interpolated normal is perpendicular to the line of sight, so each triangle holds at most one
/// segment. O(n + m).
void silhouette(const geometry::TriangleMesh& mesh, const geometry::Normals& normals, const Eye& eye,
                std::vector<float>& segments);

} // namespace viscera::scene
