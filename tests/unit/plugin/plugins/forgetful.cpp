#include <atomic>
#include <stdexcept>

#include <QObject>

#include "viscera/plugin/coordinate_system_plugin.h"

namespace viscera::tests {

/// Describes itself once, and never again.
class ForgetfulSystem final : public coordinates::CoordinateSystem {
public:
  std::string id() const override {
    failWhenAskedAgain(askedId_);
    return "forgetful";
  }
  std::string name() const override {
    failWhenAskedAgain(askedName_);
    return "Forgetful";
  }
  std::string summary() const override {
    failWhenAskedAgain(askedSummary_);
    return "Describes itself once.";
  }
  coordinates::Traits traits() const override {
    failWhenAskedAgain(askedTraits_);
    coordinates::Traits traits;
    traits.positive = true;
    return traits;
  }
  std::vector<coordinates::Parameter> parameters() const override {
    failWhenAskedAgain(askedParameters_);
    coordinates::Parameter steepness;
    steepness.name = "steepness";
    steepness.minimum = 1;
    steepness.maximum = 3;
    steepness.standard = 2;
    return {steepness};
  }
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points&,
                                             const coordinates::BindOptions&, Progress&) const override {
    throw 7;
  }

private:
  static void failWhenAskedAgain(std::atomic<bool>& asked) {
    if (asked.exchange(true))
      throw std::logic_error("who was I?");
  }

  mutable std::atomic<bool> askedId_{false};
  mutable std::atomic<bool> askedName_{false};
  mutable std::atomic<bool> askedSummary_{false};
  mutable std::atomic<bool> askedTraits_{false};
  mutable std::atomic<bool> askedParameters_{false};
};

/// Cannot even say its name.
class NamelessSystem final : public coordinates::CoordinateSystem {
public:
  std::string id() const override { return "nameless"; }
  std::string name() const override { throw 7; }
  std::string summary() const override { return {}; }
  coordinates::Traits traits() const override { return {}; }
  std::vector<coordinates::Parameter> parameters() const override { return {}; }
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet&, const Points&,
                                             const coordinates::BindOptions&, Progress&) const override {
    return nullptr;
  }
};

/// Brings one system that cannot be described, and one that can be described once.
class ForgetfulPlugin final : public QObject, public plugin::CoordinateSystemPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID VISCERA_COORDINATE_SYSTEM_PLUGIN_IID FILE "manifest.json")
  Q_INTERFACES(viscera::plugin::CoordinateSystemPlugin)

public:
  std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> systems() const override {
    return {std::make_shared<NamelessSystem>(), std::make_shared<ForgetfulSystem>()};
  }
};

} // namespace viscera::tests

#include "forgetful.moc"
