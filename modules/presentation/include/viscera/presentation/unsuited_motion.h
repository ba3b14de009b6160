#pragma once

#include "viscera/core/phrase.h"
#include "viscera/document/document.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/sequence.h"

namespace viscera::presentation {

/// The index in `view.motions` of the motion that a session plays, or else of the first that it offers; -1
/// for the one that the document holds.
int motionOf(const ViewState& view);

/// The warning that `sequence`, which that motion makes, is not made for the organ that it moves
/// (`live::unsuitedTo`), to be shown before any number of it. Empty for an organ that suits it, for a name
/// that says no organ, and for the document's own sequence. O(1); thread-safe.
Text unsuitedMotion(const document::DocumentState& state, const ViewState& view,
                    const sequences::Sequence& sequence);

} // namespace viscera::presentation
