#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/phrase.h"

namespace viscera::plugin {

/// The description of a plugin: id, name, version and summary; read from the file without running any of its
/// code.
struct PluginManifest {
  std::string id;
  std::string name;
  std::string version;
  std::string summary;
};

/// Whether a file was loaded as a plugin, and if not, why.
struct PluginReport {
  std::filesystem::path file;
  PluginManifest manifest;          ///< Empty when it has none.
  std::vector<std::string> systems; ///< Ids that were added to the registry.
  Text problem;                     ///< Why it, or one of its systems, was left out; empty when all is well.
};

/// Folders and files in the order in which they are searched: `given` (from `--plugin-path`), then those of
/// the environment variable `VISCERA_PLUGIN_PATH` (separated by colons), then `installed` where it exists.
std::vector<std::filesystem::path> pluginSearchPath(const std::vector<std::filesystem::path>& given,
                                                    const std::filesystem::path& installed);

/// Loads every plugin of the search path (a folder: its shared libraries, by name) and adds its systems to
/// `registry` with the file as their source. Never throws: a file that fails is reported with its reason, and
/// the others are loaded. A file that is named explicitly is reported when it is missing; a folder that does
/// not exist is reported once.
///
///     Registry registry = builtInRegistry();
///     const auto reports = loadPlugins(pluginSearchPath({"plugins"}, {}), registry);
///     const auto system = registry.find("s-celestial");
std::vector<PluginReport> loadPlugins(const std::vector<std::filesystem::path>& searchPath,
                                      coordinates::Registry& registry);

} // namespace viscera::plugin
