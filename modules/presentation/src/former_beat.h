#pragma once

#include "viscera/document/circulation_choice.h"
#include "viscera/presentation/view_state.h"

namespace viscera::presentation {

/// Moves the instants of a heartbeat that a view of format 1 or 2 has saved: there the textbook's beat began
/// with the contraction of the atria and that of a circulation with the contraction of the ventricles; now
/// both begin `heart::kBeforeAtria` before the atria contract. The present instant, the slides and a
/// prescribed volume get the fractions at which the heart is as it was. Other motions are left as they are.
/// `circulation` is the session's.
void beginBeforeAtria(ViewState& view, const document::CirculationChoice& circulation);

} // namespace viscera::presentation
