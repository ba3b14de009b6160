#include "guarded_system.h"

#include <exception>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::plugin {
namespace {

constexpr int kInternalError = 70;

class GuardedSystem final : public coordinates::CoordinateSystem {
public:
  GuardedSystem(std::shared_ptr<const coordinates::CoordinateSystem> system, std::string file)
      : system_(std::move(system)), file_(std::move(file)), id_(system_->id()) {}

  std::string id() const override { return id_; }
  std::string name() const override { return system_->name(); }
  std::string summary() const override { return system_->summary(); }
  coordinates::Traits traits() const override { return system_->traits(); }
  std::vector<coordinates::Parameter> parameters() const override { return system_->parameters(); }

  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override {
    auto binding = behindWall([&] { return system_->bind(handles, points, options, progress); });
    if (!binding || binding->pointCount() != points.rows() ||
        binding->handleCount() != handles.positions.rows())
      throw Error(kInternalError, "system '" + id_ + "' returned no binding of the right size", file_);
    return binding;
  }

  coordinates::CoordinateGradients gradients(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override {
    return behindWall([&] { return system_->gradients(handles, points, options, progress); });
  }

  coordinates::SpaceLayout layout(const coordinates::HandleSet& handles,
                                  const coordinates::ParameterValues& parameters) const override {
    return behindWall([&] { return system_->layout(handles, parameters); });
  }

private:
  template <class Call>
  auto behindWall(const Call& call) const -> decltype(call()) {
    try {
      return call();
    } catch (const Error&) {
      throw;
    } catch (const std::exception& error) {
      throw Error(kInternalError, "system '" + id_ + "' failed: " + error.what(), file_,
                  "choose another system");
    } catch (...) {
      throw Error(kInternalError, "system '" + id_ + "' failed", file_, "choose another system");
    }
  }

  std::shared_ptr<const coordinates::CoordinateSystem> system_;
  std::string file_;
  std::string id_;
};

} // namespace

std::shared_ptr<const coordinates::CoordinateSystem>
guarded(std::shared_ptr<const coordinates::CoordinateSystem> system, std::string pluginFile) {
  return std::make_shared<GuardedSystem>(std::move(system), std::move(pluginFile));
}

} // namespace viscera::plugin
