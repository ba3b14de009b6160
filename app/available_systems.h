#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/phrase.h"

namespace viscera::app {

/// The coordinate systems that this program can use, built in or from plugins.
struct AvailableSystems {
  coordinates::Registry registry;
  std::vector<Text> problems; ///< One sentence for each plugin that was left out.
};

/// The built-in systems and those of plugins: from `pluginPath` (folders and files), the environment variable
/// VISCERA_PLUGIN_PATH, and the folder that belongs to this program, in this order. A plugin that cannot be
/// loaded is a problem and nothing more.
AvailableSystems availableSystems(const std::vector<std::string>& pluginPath);

} // namespace viscera::app
