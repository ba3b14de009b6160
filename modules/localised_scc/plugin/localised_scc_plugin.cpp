#include <QObject>

#include "viscera/localised_scc/localised_s_celestial.h"
#include "viscera/plugin/coordinate_system_plugin.h"

namespace viscera::localised_scc {

/// The plugin that adds the localised coordinates to a program, with every built-in system inside that is
/// positive and needs nothing but handles.
class LocalisedSccPlugin final : public QObject, public plugin::CoordinateSystemPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID VISCERA_COORDINATE_SYSTEM_PLUGIN_IID FILE "localised_scc.json")
  Q_INTERFACES(viscera::plugin::CoordinateSystemPlugin)

public:
  std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems() const override {
    return {localisedWithBuiltIns()};
  }
};

} // namespace viscera::localised_scc

#include "localised_scc_plugin.moc"
