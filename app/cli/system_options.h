#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/coordinates/measure/system_properties.h"

namespace viscera::app::cli {

/// Defines the options `--system`, `--param` and `--cage` of several commands, and reads them.
class SystemOptions {
public:
  void addTo(CLI::App& options);

  /// The chosen system. Throws `UsageError` that lists the existing ones.
  std::shared_ptr<const coordinates::CoordinateSystem> system(const CommandContext& context) const;

  /// The values given for it, checked, with the threads. Throws `UsageError` for what is not `name=value`,
  /// and for a name or value that the system does not take. Of two systems that are compared, `beside` being
  /// the other one, each is given what it takes.
  coordinates::BindOptions bindOptions(const coordinates::CoordinateSystem& system,
                                       const CommandContext& context,
                                       const coordinates::CoordinateSystem* beside = nullptr) const;

  /// The surface file whose triangles are the cage over the handles; empty: none is given.
  const std::string& cage() const { return cage_; }

private:
  std::string cage_;
  std::string id_ = "s-celestial";
  std::vector<std::string> parameters_;
};

/// Each of `systems` with those of `parameters` ("name=value") that it takes. Throws `UsageError` for one
/// that none of them takes, and for a value out of range.
std::vector<coordinates::SystemVariant>
variantsOf(const std::vector<std::shared_ptr<const coordinates::CoordinateSystem>>& systems,
           const std::vector<std::string>& parameters);

} // namespace viscera::app::cli
