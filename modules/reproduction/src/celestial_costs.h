#pragma once

#include "viscera/reproduction/item.h"

/// What it costs to bind, side by side (figures 4.12, 4.18 and 4.23).
namespace viscera::reproduction {

/// T- and S-Celestial on organs.
void figure412(Result& result, const Bench& bench, Progress& progress);
/// C-, T- and S-Celestial along the line.
void figure418(Result& result, const Bench& bench, Progress& progress);
/// Bounded biharmonic weights and S-Celestial on organs.
void figure423(Result& result, const Bench& bench, Progress& progress);

} // namespace viscera::reproduction
