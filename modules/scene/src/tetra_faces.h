#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/scene/tissue_actor.h"

namespace viscera::scene {

/// A triangle between two tetrahedra, or at the outside of one.
struct TetraFace {
  std::array<std::int32_t, 3> corners{}; ///< Counter-clockwise seen from outside of the first tetrahedron.
  std::int32_t first = -1;
  std::int32_t second = -1; ///< -1: nothing on the other side.
};

/// Every face once, in an order that depends on the tetrahedra only. `points` tell the outside of each. O(t).
std::vector<TetraFace> tetraFaces(const Tetrahedra& tetrahedra, const Points& points);

} // namespace viscera::scene
