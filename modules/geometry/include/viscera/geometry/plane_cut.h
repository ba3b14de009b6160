#pragma once

#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"

/// Intersects surfaces with planes, for the contours of organs on the slices of a scan.
namespace viscera::geometry {

/// A plane in space.
struct Plane {
  Vec3 origin = Vec3::Zero();  ///< A point of it, mm.
  Vec3 normal = Vec3::UnitZ(); ///< Unit.

  /// How far a point lies on the side that the normal points to, mm.
  double height(const Vec3& point) const { return normal.dot(point - origin); }
};

/// A reference to the points and triangles of a surface to be cut, which must not change meanwhile.
struct SurfaceView {
  const Points* points = nullptr;       ///< `n x 3`, mm.
  const Triangles* triangles = nullptr; ///< Rows of `points`; assumed to be in range.
};

/// The lines in which a plane cuts a surface. Seen against the plane's normal, the inside of a surface whose
/// triangles look outward is on the left of each line.
struct PlaneCut {
  Points points;                   ///< `n x 3`, mm, line after line.
  std::vector<std::int32_t> first; ///< Line i has the rows from `first[i]` up to `first[i + 1]`.
  std::vector<bool> closed;        ///< Line i ends where it begins; its first point is not repeated.
  double lengthMm = 0;             ///< Of all lines.

  std::size_t lines() const { return closed.size(); }
};

/// Cuts every surface by every plane: result `[surface][plane]`. The triangles are read once for all planes,
/// so that three cost little more than one. A vertex in a plane counts as above it: no triangle is cut twice
/// and no line ends at a vertex, but a triangle that lies in the plane adds no line. At most eight planes,
/// else `UsageError`. O(points * planes + triangles + p log p) for p points in the result, on several
/// threads; the result does not depend on how many.
std::vector<std::vector<PlaneCut>> cutSurfaces(const std::vector<SurfaceView>& surfaces,
                                               const std::vector<Plane>& planes, Threads threads = {});

/// Cuts one surface by one plane.
PlaneCut cutSurface(const SurfaceView& surface, const Plane& plane, Threads threads = {});

/// Whether a point of the plane lies inside of the cut's closed lines (by the parity of crossings along a ray
/// in the plane). Open lines are left out. O(points).
bool isInside(const PlaneCut& cut, const Plane& plane, const Vec3& point);

} // namespace viscera::geometry
