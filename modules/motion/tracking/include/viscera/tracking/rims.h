#pragma once

#include <cstdint>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::tracking {

/// The vertices of one opening of a surface (a valve) in their order along its rim, the first not repeated.
using Rim = std::vector<std::int32_t>;

/// One surface in one phase with the rims of its openings, which caps have closed.
struct RimmedSurface {
  const geometry::TriangleMesh* mesh = nullptr; ///< Never null.
  const std::vector<Rim>* rims = nullptr;       ///< Never null; the vertices of `mesh`.
};

/// The rims that a surface has in every phase, the same opening at the same place of each list:
/// `[phase][rim]`. Rims that are shorter than a fifth of the surface's diagonal are faults of a mesh and no
/// valves; the others are told apart by where their middles lie, from one phase to the next. Empty when
/// phases have different numbers of them, or none. O(points of rims + rims^3).
std::vector<std::vector<Rim>> commonRims(const std::vector<RimmedSurface>& phases);

/// The points of a rim, `n x 3` mm.
Points pointsOf(const Rim& rim, const Points& points);

/// The part of a rim (`n x 3` mm) that is nearest to each of its points along it: half of its two edges, `n`
/// numbers, mm.
Values lengthsAlong(const Points& rim);

/// The nearest place of a closed line (`n x 3`) and the line's direction there, a unit vector; zero for a
/// line without length. O(n).
struct PlaceOnRim {
  Vec3 point;
  Vec3 direction;
};
PlaceOnRim nearestOnRim(const Points& rim, const Vec3& point);

} // namespace viscera::tracking
