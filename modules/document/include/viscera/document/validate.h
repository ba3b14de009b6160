#pragma once

#include <cstdint>

#include "viscera/document/document.h"

namespace viscera::document {

/// The largest absolute coordinate that a document accepts, mm; volumes computed from such places stay
/// finite.
inline constexpr double kFarthestMm = 1e9;
/// No id is larger: JSON's numbers are whole up to twice as much.
inline constexpr std::int64_t kLargestId = std::int64_t{1} << 52;

/// Checks the rules that every document and every session file obeys: names that are not empty, unique and
/// UTF-8; numbers in their ranges; places that are finite and not farther than `kFarthestMm`; references only
/// to parts that exist. Commands, the writer and the reader of sessions all ask here, so what a command
/// accepts can be saved, and what was saved can be read. Throws `DataError` that names the part and the
/// fault.
///
/// Parts that `known`, a valid state, has by address are not looked at again; a new pose costs O(handles), a
/// new rig O(n log n). A measured point may be on an organ that is not there: its file may be found again.
void validate(const DocumentState& state, const DocumentState& known = {});

} // namespace viscera::document
