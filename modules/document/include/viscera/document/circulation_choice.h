#pragma once

#include <optional>
#include <string>

#include "viscera/circulation/parameters.h"
#include "viscera/core/phrase.h"

namespace viscera::document {

/// A circulation that the user kept, to compare the present one with it.
struct KeptCirculation {
  Text name; ///< "Rest"
  circulation::Parameters parameters;

  friend bool operator==(const KeptCirculation&, const KeptCirculation&) = default;
};

/// The user's choice of how the heart is moved: by the textbook's beat with its fixed curves, or by a
/// circulation with its parameters.
struct CirculationChoice {
  bool drives = false;           ///< The circulation moves the heart; else the textbook's beat.
  std::string scenario = "rest"; ///< The one chosen last (`circulation::scenario`), which controls vary.
  circulation::Parameters parameters;
  /// Parameters fitted to a heart's volumes, which replace the scenario; controls vary them. None: the
  /// scenario's.
  std::optional<circulation::Parameters> fitted;
  std::optional<KeptCirculation> kept; ///< "As before".

  friend bool operator==(const CirculationChoice&, const CirculationChoice&) = default;
};

/// The scenario's name, or "Fitted circulation", and whether controls were moved since: "Rest, changed".
Text nameOf(const CirculationChoice& choice);

} // namespace viscera::document
