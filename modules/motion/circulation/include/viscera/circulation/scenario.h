#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viscera/circulation/parameters.h"

namespace viscera::circulation {

/// A named state of health or illness, given by its changes to the parameters at rest.
struct Scenario {
  std::string id;      ///< "aortic-stenosis"
  std::string name;    ///< "Aortic stenosis"
  std::string summary; ///< One sentence: what is changed, and what to look at.
  std::vector<std::pair<std::string, double>> changes; ///< Parameter and its value.
  /// The mass of the left ventricle's muscle, as a part of a healthy one's. It is only drawn and enters no
  /// equation: the effect of a thick wall on pressures and volumes is among the changes (stiffness,
  /// relaxation, strength).
  double leftMuscle = 1;
};

/// All scenarios: rest first, then in the order in which they are taught. Thread-safe.
const std::vector<Scenario>& scenarios();

/// Throws `UsageError` that lists the scenarios for an unknown id.
const Scenario& scenario(const std::string& id);

/// The muscle of the scenario with this name, which may end in ", changed"; 1 for any other name.
double leftMuscleOf(const std::string& name);

/// The parameters of a scenario: those at rest with the scenario's changes. Throws as `scenario`.
Parameters scenarioParameters(const std::string& id);

} // namespace viscera::circulation
