#include "available_systems.h"

#include <system_error>

#include "viscera/core/phrase.h"
#include "viscera/plugin/plugin_loader.h"

namespace viscera::app {
namespace {

namespace fs = std::filesystem;

/// The folder of the plugins that are installed with this program: beside the libraries of the installation,
/// or of the build.
fs::path ownPlugins() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error)
    return {};
  for (const char* fromProgram : {VISCERA_PLUGINS_FROM_BINDIR, "../lib/viscera/plugins"}) {
    const fs::path folder = (program.parent_path() / fromProgram).lexically_normal();
    if (fs::is_directory(folder, error))
      return folder;
  }
  return {};
}

} // namespace

AvailableSystems availableSystems(const std::vector<std::string>& pluginPath) {
  AvailableSystems systems{coordinates::builtInRegistry(), {}};
  const std::vector<fs::path> given(pluginPath.begin(), pluginPath.end());
  for (const plugin::PluginReport& report :
       plugin::loadPlugins(plugin::pluginSearchPath(given, ownPlugins()), systems.registry))
    if (!report.problem.empty())
      systems.problems.push_back(phrase("plugin %1: %2", report.file.string(), report.problem));
  return systems;
}

} // namespace viscera::app
