#pragma once

#include "viscera/coordinates/space_layout.h"
#include "viscera/localised_scc/region_layout.h"

namespace viscera::localised_scc {

/// What a scene can draw of `layout`, which was made from `groups` groups; with the upper bound of the
/// parameter `offsetName`.
coordinates::SpaceLayout spaceLayoutOf(const RegionLayout& layout, std::size_t groups,
                                       const std::string& offsetName);

} // namespace viscera::localised_scc
