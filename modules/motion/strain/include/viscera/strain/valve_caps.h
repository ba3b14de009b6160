#pragma once

#include <optional>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::strain {

/// The triangles that close the valves of a cavity: they are no wall.
struct ValveCaps {
  std::vector<bool> triangles;        ///< One for each triangle of the surface.
  Vec3 largestMiddle = Vec3::Zero();  ///< Middle of the rim of the largest cap, mm.
  Vec3 largestNormal = Vec3::UnitZ(); ///< Unit, out of the cavity.
  int caps = 0;
};

/// Finds the caps of a closed cavity with outward triangles. A hole that was closed by a flat fan is a cap:
/// its middle is the mean of its rim, of the points or, as `geometry::closeHoles` makes it, of the edges.
/// Where a surface has no such fan, the cap is the flat part at its end `towardsBase`: connected triangles
/// that look there, to within 40 degrees. Without `towardsBase` the ends are those of the longest principal
/// axis, and the base is the flatter one. There is always one cap at least. Throws `DataError` for less than
/// four triangles or without area. O(n + m).
ValveCaps valveCaps(const geometry::TriangleMesh& cavity, const std::optional<Vec3>& towardsBase = {});

} // namespace viscera::strain
