#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

/// Creates an instance of every coordinate system of this library, in the order in which a list shows them.
std::vector<std::shared_ptr<const CoordinateSystem>> builtInSystems();

} // namespace viscera::coordinates
