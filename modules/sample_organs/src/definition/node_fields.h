#pragma once

#include <vector>

#include "definition/fields.h"
#include "implicit/tube.h"

/// Reads the fields that nodes and paths have in common.
namespace viscera::sample_organs {

/// The largest seed of random shapes.
inline constexpr int kMostSeed = 1'000'000;

/// Whether an object with the field `lod` exists at that level (0 low, 1 medium, 2 high).
bool presentAt(Fields& fields, int level);

/// The look of a node, whose fields are all optional: `paint` (red, green, blue from 0 to 1), `edge_scale`,
/// and `mottle` (`amount`, `wavelength` in mm).
Finish finishFrom(Fields& fields);

/// The axis of a tube: `points`, each `[x, y, z, radius]`, at least two, neighbours apart.
std::vector<AxisPoint> axisFrom(Fields& fields);

/// The other fields of a tube: `flatten`, `caps`, `rim`, `lumen`, `haustra`, `waves`, `folds`, `step`. Parts
/// that do not exist at that level are left out.
TubeShape tubeShapeFrom(Fields& fields, int level);

} // namespace viscera::sample_organs
