#include <new>
#include <stdexcept>

#include <QObject>

#include "viscera/coordinates/systems.h"
#include "viscera/plugin/coordinate_system_plugin.h"

namespace viscera::tests {

/// A system that fails in a way of its own.
class FailingSystem final : public coordinates::CoordinateSystem {
public:
  std::string id() const override { return "failing"; }
  std::string name() const override { return "Failing"; }
  std::string summary() const override { return "Throws what is no error of ours."; }
  coordinates::Traits traits() const override { return {}; }
  std::vector<coordinates::Parameter> parameters() const override { return {}; }
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points&,
                                             const coordinates::BindOptions&, Progress&) const override {
    throw std::logic_error("out of cheese");
  }
  coordinates::CoordinateGradients gradients(const coordinates::HandleSet&, const Points&,
                                             const coordinates::BindOptions&, Progress&) const override {
    throw std::bad_alloc();
  }
};

/// Brings a system whose id is taken, and one that fails when it is used.
class DuplicatePlugin final : public QObject, public plugin::CoordinateSystemPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID VISCERA_COORDINATE_SYSTEM_PLUGIN_IID FILE "manifest.json")
  Q_INTERFACES(viscera::plugin::CoordinateSystemPlugin)

public:
  std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems() const override {
    return {coordinates::builtInSystems().front(), std::make_shared<FailingSystem>()};
  }
};

} // namespace viscera::tests

#include "duplicate.moc"
