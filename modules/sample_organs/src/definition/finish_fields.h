#pragma once

#include "definition/fields.h"
#include "implicit/implicit_node.h"

namespace viscera::sample_organs {

/// The look of a node, of which all may be missing: `paint` (red, green, blue from 0 to 1), `edge_scale`, and
/// `mottle` (`amount`, `wavelength` in mm).
Finish finishFrom(Fields& fields);

} // namespace viscera::sample_organs
