#pragma once

#include <cstdint>

#include "viscera/document/document.h"

/// Checks the rules that the state of every document obeys.
namespace viscera::document {

/// The largest absolute coordinate that a document accepts, mm; volumes computed from such places stay
/// finite.
inline constexpr double kFarthestMm = 1e9;
/// The largest id; JSON numbers are exact up to twice as much.
inline constexpr std::int64_t kLargestId = std::int64_t{1} << 52;

/// Checks the rules that every document and every session file obeys: names that are not empty, unique and
/// UTF-8; numbers in their ranges; places that are finite and not farther than `kFarthestMm`; references only
/// to parts that exist. Commands and the writer and reader of sessions all call it, so every state that a
/// command accepts can be saved and read again. Throws `DataError` that names the part and the fault.
///
/// Parts that `known`, a valid state, shares by address are not checked again; a new pose costs O(handles), a
/// new rig O(n log n). A measured point may refer to a missing organ, whose file may be found later.
void validate(const DocumentState& state, const DocumentState& known = {});

} // namespace viscera::document
