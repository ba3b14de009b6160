#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viscera/coordinates/parameters.h"

/// Helper functions that create parameters of coordinate systems and read their values.
namespace viscera::coordinates {

/// A parameter whose value is one of `choices`; the first one is the standard.
inline Parameter choiceParameter(std::string name, std::string help, std::vector<std::string> choices) {
  return {.name = std::move(name),
          .maximum = static_cast<double>(choices.size()) - 1,
          .help = std::move(help),
          .integer = true,
          .choices = std::move(choices)};
}

/// A whole number without a unit.
inline Parameter countParameter(std::string name, std::string help, double minimum, double maximum,
                                double standard) {
  return {.name = std::move(name),
          .minimum = minimum,
          .maximum = maximum,
          .standard = standard,
          .help = std::move(help),
          .integer = true};
}

/// The index of the choice that was made, as the enumeration that lists the choices in the same order.
template <class Enumeration>
Enumeration chosen(const ParameterValues& values, const Parameter& parameter) {
  return static_cast<Enumeration>(static_cast<int>(values.get(parameter)));
}

} // namespace viscera::coordinates
