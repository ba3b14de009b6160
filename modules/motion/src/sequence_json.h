#pragma once

#include <string>

#include "viscera/motion/sequence_file.h"

/// The text of a sequence file.
namespace viscera::motion {

/// `where` names the file in messages. Throws `DataError` as `readSequence` says.
SequenceFile sequenceFromJson(const std::string& text, const std::string& where);

/// Every number with the digits that bring back its bits.
std::string sequenceToJson(const SequenceFile& sequence);

} // namespace viscera::motion
