#pragma once

#include <memory>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::examples {

/// The affine combination of the handles with the least sum of squares, as a worked example of
/// docs/developer_guide.md.
std::shared_ptr<const coordinates::CoordinateSystem> leastNormSystem();

} // namespace viscera::examples
