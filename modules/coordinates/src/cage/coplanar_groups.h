#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// Groups of a closed cage's triangles that are joined by edges and lie in one plane, to 1e-9 of the cage's
/// size: the number of its group for each triangle, that of a triangle in it. A triangle that has no width,
/// to the same, lies in many planes: it goes with the one beyond its longest edge. O(m log m), and O(m) more
/// for each pair of triangles that is joined.
std::vector<int> coplanarGroups(const Points& handles, const Triangles& cage);

} // namespace viscera::coordinates
