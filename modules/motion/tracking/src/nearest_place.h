#pragma once

#include <array>
#include <cstdint>

#include "viscera/geometry/median_tree.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::tracking {

/// A place on a surface: a triangle and the weights of its corners, which add up to 1.
struct SurfacePlace {
  Eigen::Index triangle = -1;
  Vec3 corners = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  double apart = 0; ///< From the point that was asked for, mm.
};

/// Finds the nearest place of a surface and the triangle that it is on. Immutable; may be asked from several
/// threads. Does not keep the mesh alive.
class NearestPlace {
public:
  /// O(m log m).
  NearestPlace(const Points& points, const Triangles& triangles);

  /// O(log m).
  SurfacePlace of(const Vec3& point) const;

private:
  const Points& points_;
  const Triangles& triangles_;
  Points middles_;
  geometry::MedianTree<Bounds> boxes_;
};

} // namespace viscera::tracking
