#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viscera/coordinates/parameters.h"

namespace viscera::coordinates {

/// A parameter whose value is one of `choices`; the first one is the standard.
inline Parameter choiceParameter(std::string name, std::string help, std::vector<std::string> choices) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.maximum = static_cast<double>(choices.size()) - 1;
  parameter.help = std::move(help);
  parameter.integer = true;
  parameter.choices = std::move(choices);
  return parameter;
}

/// A whole number without a unit.
inline Parameter countParameter(std::string name, std::string help, double minimum, double maximum,
                                double standard) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  parameter.standard = standard;
  parameter.help = std::move(help);
  parameter.integer = true;
  return parameter;
}

/// The index of the choice that was made, as the enumeration that lists the choices in the same order.
template <class Enumeration>
Enumeration chosen(const ParameterValues& values, const Parameter& parameter) {
  return static_cast<Enumeration>(static_cast<int>(values.get(parameter)));
}

} // namespace viscera::coordinates
