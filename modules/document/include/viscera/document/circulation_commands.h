#pragma once

#include <string>

#include "viscera/circulation/parameters.h"
#include "viscera/document/command.h"

/// Commands that choose between the circulation and the textbook's beat, and change the circulation.
namespace viscera::document {

/// Sets whether the circulation or the textbook's beat moves the heart. The circulation is not changed.
Command driveHeart(bool byCirculation);

/// Chooses a scenario with all its parameters, and lets it move the heart. A kept circulation stays. Throws
/// `UsageError` for an unknown one.
Command chooseScenario(const std::string& id);

/// Sets one parameter (`circulation::parameterInfos`). Changes of one parameter one after the other are one
/// undo step. Throws `UsageError` for an unknown name, a value out of its range, and a valve that would leak
/// through a larger area than it opens to.
Command setCirculationParameter(const std::string& name, double value);

/// Takes a circulation that was fitted to a heart, such as a patient's, and lets it move the heart. It is
/// called "Fitted circulation" until a scenario is chosen. What was kept stays. Throws `UsageError` for
/// parameters out of their ranges.
Command takeCirculation(Text title, const circulation::Parameters& parameters);

/// Keeps the present circulation, for comparison with later ones.
Command keepCirculation();
/// Forgets the kept circulation. Nothing happens when none is kept.
Command forgetKeptCirculation();

} // namespace viscera::document
