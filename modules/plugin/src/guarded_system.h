#pragma once

#include <memory>
#include <string>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::plugin {

/// A plugin's system behind a wall: whatever it throws that is not one of our errors arrives as one, with the
/// plugin's name, so that a foreign mistake never ends the program.
std::shared_ptr<const coordinates::CoordinateSystem>
guarded(std::shared_ptr<const coordinates::CoordinateSystem> system, std::string pluginFile);

} // namespace viscera::plugin
