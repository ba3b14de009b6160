#include "viscera/coordinates/built_in_systems.h"

#include "viscera/coordinates/celestial/s_celestial.h"
#include "viscera/coordinates/celestial/t_celestial.h"
#include "viscera/coordinates/mean_value/mean_value.h"

namespace viscera::coordinates {

std::vector<std::shared_ptr<const CoordinateSystem>> builtInSystems() {
  return {std::make_shared<SCelestial>(), std::make_shared<TCelestial>(), std::make_shared<MeanValue>()};
}

} // namespace viscera::coordinates
