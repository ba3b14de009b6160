#pragma once

#include <memory>
#include <stdexcept>

#include "lines.h"
#include "viscera/coordinates/measure/line_profile.h"
#include "viscera/coordinates/systems.h"

/// Measures a built-in system along one of the lines, in one call.
namespace viscera::tests {

inline std::shared_ptr<const coordinates::CoordinateSystem> builtIn(const std::string& id) {
  for (auto& system : coordinates::builtInSystems())
    if (system->id() == id)
      return system;
  throw std::logic_error("there is no " + id);
}

using Choices = std::vector<std::pair<std::string, std::string>>;

inline coordinates::BindOptions optionsFor(const coordinates::CoordinateSystem& system,
                                           const Choices& choices) {
  coordinates::BindOptions options;
  for (const auto& [name, value] : choices)
    options.parameters.setFromText(system.parameters(), name, value);
  return options;
}

inline coordinates::LineProperties alongLine(const std::string& id, int handles, const Choices& choices = {},
                                             int parts = 400) {
  Progress progress;
  const auto system = builtIn(id);
  return coordinates::measureAlong(*system, handlesAroundLine(handles), {kLineFrom, kLineTo}, parts,
                                   optionsFor(*system, choices), progress);
}

} // namespace viscera::tests
