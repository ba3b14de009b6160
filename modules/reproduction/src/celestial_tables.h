#pragma once

#include "viscera/reproduction/item.h"

/// The thesis's tables of properties, by measurement (4.1 and 4.2).
namespace viscera::reproduction {

/// C-, T- and S-Celestial: rotation invariant, interpolating, efficient.
void table41(Result& result, const Bench& bench, Progress& progress);
/// The same beside mean value coordinates and bounded biharmonic weights.
void table42(Result& result, const Bench& bench, Progress& progress);

} // namespace viscera::reproduction
