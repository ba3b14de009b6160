#pragma once

#include <optional>
#include <string>

#include "viscera/circulation/parameters.h"

namespace viscera::document {

/// A circulation that the user kept, to compare the present one with it.
struct KeptCirculation {
  std::string name; ///< "Rest"
  circulation::Parameters parameters;

  friend bool operator==(const KeptCirculation&, const KeptCirculation&) = default;
};

/// The user's choice of what moves the heart: the textbook's beat with its fixed curves, or a circulation
/// with its parameters.
struct CirculationChoice {
  bool drives = false;           ///< The circulation does; else the textbook's beat.
  std::string scenario = "rest"; ///< The one chosen last (`circulation::scenario`), which controls vary.
  circulation::Parameters parameters;
  std::optional<KeptCirculation> kept; ///< "As before".

  friend bool operator==(const CirculationChoice&, const CirculationChoice&) = default;
};

/// The scenario's name, and whether its controls were moved since: "Rest", "Rest, changed".
std::string nameOf(const CirculationChoice& choice);

} // namespace viscera::document
