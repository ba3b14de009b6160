#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/live/sequence_file.h"

/// Says that a motion is not made for an organ, judged by the organ's name (`anatomy::partNamed`): a
/// heartbeat in a liver moves it, and no number that is measured then means anything. The text comes before
/// any number.
namespace viscera::live {

/// The warning for a shipped sequence on an organ. Empty where the organ is of the kind that the sequence
/// moves, where its name says no organ ("mesh 1"), and for an unknown sequence.
Text unsuitedTo(const std::string& sequence, const std::string& organName);

/// The same for a motion that was recorded of, or found in, organs of these names. Empty where one of them is
/// of the same kind, and where no name or not the organ's says one.
Text unsuitedTo(const std::vector<std::string>& recordedOf, const std::string& organName);

/// The same for the organs in a sequence file.
Text unsuitedTo(const SequenceFile& sequence, const std::string& organName);

} // namespace viscera::live
