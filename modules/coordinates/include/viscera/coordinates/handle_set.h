#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// A named set of handles that act together.
struct HandleGroup {
  std::string name;
  std::vector<int> handles; ///< Rows of `HandleSet::positions`; a handle may be in several groups.
};

/// What a coordinate system is bound to: the handles at rest, and the structures some systems need beside
/// them.
struct HandleSet {
  Points positions;                ///< `n x 3`, mm, LPS: the rest pose.
  Triangles cage;                  ///< Triangles over `positions`, outward; empty for systems that need none.
  std::vector<HandleGroup> groups; ///< Empty: all handles form one group.
};

} // namespace viscera::coordinates
