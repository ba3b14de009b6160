#pragma once

#include "reproduction/item.h"

/// The thesis's tables of properties, by measurement (4.1 and 4.2).
namespace viscera::app::reproduction {

/// C-, T- and S-Celestial: rotation invariant, interpolating, efficient.
void table41(Result& result, const cli::Surroundings& surroundings, Progress& progress);
/// The same beside mean value coordinates and bounded biharmonic weights.
void table42(Result& result, const cli::Surroundings& surroundings, Progress& progress);

} // namespace viscera::app::reproduction
