#include "viscera/coordinates/built_in_systems.h"

#include "viscera/coordinates/celestial/s_celestial.h"
#include "viscera/coordinates/celestial/t_celestial.h"

namespace viscera::coordinates {

std::vector<std::shared_ptr<const CoordinateSystem>> builtInSystems() {
  return {std::make_shared<SCelestial>(), std::make_shared<TCelestial>()};
}

} // namespace viscera::coordinates
