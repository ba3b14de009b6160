#include <stdexcept>

#include <QObject>

#include "viscera/plugin/coordinate_system_plugin.h"

namespace viscera::tests {

/// Brings nothing but trouble.
class ThrowingPlugin final : public QObject, public plugin::CoordinateSystemPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID VISCERA_COORDINATE_SYSTEM_PLUGIN_IID FILE "manifest.json")
  Q_INTERFACES(viscera::plugin::CoordinateSystemPlugin)

public:
  std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems() const override {
    throw std::runtime_error("no disk in drive");
  }
};

} // namespace viscera::tests

#include "throws.moc"
