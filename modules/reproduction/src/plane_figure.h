#pragma once

#include "viscera/reproduction/item.h"

namespace viscera::reproduction {

/// The influence of one handle in the plane, for every system that has a planar form, in a convex and in a
/// concave polygon. Fills `result` as `Item::make`.
void planeFigure(Result& result, const Bench& bench, Progress& progress);

} // namespace viscera::reproduction
