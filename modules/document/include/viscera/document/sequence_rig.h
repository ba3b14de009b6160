#pragma once

#include "viscera/document/rig.h"
#include "viscera/document/rig_commands.h"
#include "viscera/sequences/sequence.h"

/// The handles of a sequence as a document has them.
namespace viscera::document {

/// Throws `DataError` when a sequence cannot move these handles: another number of them or another rest pose
/// (apart by more than 1e-6 of the size). It says to take the sequence's own handles.
void requireFits(const Rig& rig, const sequences::Sequence& sequence);

/// The sequence's own handles, for `replaceRig`: in its groups, each handle labelled after its group.
NewRig rigOf(const sequences::Sequence& sequence);

} // namespace viscera::document
