#pragma once

#include "viscera/coordinates/handle_set.h"

namespace viscera::coordinates {

/// The closed, outward triangles over the handles that a cage system works with: the rig's own cage, else the
/// convex hull of the handles (whose inner handles then have no influence). Throws `DataError` for a cage
/// whose triangles name handles that do not exist, or that is open or not manifold: it says at how many
/// edges; for no cage and handles that are all in one plane. For any thread. O(n log n).
Triangles cageOf(const HandleSet& handles);

} // namespace viscera::coordinates
