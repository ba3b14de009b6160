#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/signed_distance.h"

namespace viscera::strain {

/// The distance from a part of a surface, which may be open: one without the caps of its valves. Immutable;
/// thread-safe.
class OpenSurface {
public:
  /// Leaves out the triangles that `leftOut` marks (a flag each, or empty); something has to be left. O(m log
  /// m).
  OpenSurface(const Points& points, const Triangles& triangles, const std::vector<bool>& leftOut = {});

  /// mm, never negative. O(log m).
  double distanceTo(const Vec3& point) const { return (distance_.nearest(point) - point).norm(); }

private:
  geometry::SignedDistance distance_;
};

/// The triangles that `leftOut` does not mark, or those that it does.
Triangles withoutMarked(const Triangles& triangles, const std::vector<bool>& leftOut);
Triangles onlyMarked(const Triangles& triangles, const std::vector<bool>& marked);

} // namespace viscera::strain
