#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// A named group of handles, by their row numbers.
struct HandleGroup {
  std::string name;
  std::vector<int> handles; ///< Rows of `HandleSet::positions`; a handle may be in several groups.
};

/// The handles at rest with their groups and cage, which is what a coordinate system needs to bind points.
struct HandleSet {
  Points positions;                ///< `n x 3`, mm, LPS: the rest pose.
  Triangles cage;                  ///< Triangles over `positions`, outward; empty for systems that need none.
  std::vector<HandleGroup> groups; ///< Empty: all handles form one group.
};

} // namespace viscera::coordinates
