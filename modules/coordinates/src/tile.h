#pragma once

#include "viscera/coordinates/tiled_weights.h"

namespace viscera::coordinates {

/// Points of a tile.
inline constexpr int kTile = TiledWeights::kTile;

} // namespace viscera::coordinates
