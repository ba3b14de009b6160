#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

/// A new instance of every system that this library holds, in the order in which a list shows them.
std::vector<std::shared_ptr<const CoordinateSystem>> builtInSystems();

} // namespace viscera::coordinates
