#pragma once

#include <memory>
#include <vector>

#include <QtPlugin>

#include "viscera/coordinates/coordinate_system.h"

/// The interface's name; the number after the slash changes when a plugin made for the interface before would
/// not work.
#define VISCERA_COORDINATE_SYSTEM_PLUGIN_IID "org.viscera.CoordinateSystemPlugin/2"

namespace viscera::plugin {

/// The interface of plugins with coordinate systems, to be implemented in a QObject with
/// `Q_PLUGIN_METADATA(IID VISCERA_COORDINATE_SYSTEM_PLUGIN_IID FILE "manifest.json")` and
/// `Q_INTERFACES(viscera::plugin::CoordinateSystemPlugin)`. The manifest names `id`, `name`, `version` and
/// `summary`, so that a program can list a plugin without loading it. See docs/coordinate_plugin.md.
class CoordinateSystemPlugin {
public:
  virtual ~CoordinateSystemPlugin() = default;

  /// The systems of the plugin; called once. The library is never unloaded, so they live as long as the
  /// program.
  virtual std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems() const = 0;
};

} // namespace viscera::plugin

Q_DECLARE_INTERFACE(viscera::plugin::CoordinateSystemPlugin, VISCERA_COORDINATE_SYSTEM_PLUGIN_IID)
