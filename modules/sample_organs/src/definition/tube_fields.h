#pragma once

#include <vector>

#include "definition/fields.h"
#include "implicit/tube.h"

namespace viscera::sample_organs {

/// The axis of a tube: `points`, each `[x, y, z, radius]`, at least two, neighbours apart.
std::vector<AxisPoint> axisFrom(Fields& fields);

/// The other fields of a tube: `flatten`, `caps`, `rim`, `lumen`, `haustra`, `waves`, `folds`, `step`. Parts
/// that say `lod` are left out below that level (0 low, 1 medium, 2 high).
TubeShape tubeShapeFrom(Fields& fields, int level);

} // namespace viscera::sample_organs
