#pragma once

#include "viscera/reproduction/item.h"

/// Newton's method as the thesis begins it, from a neighbour's solution (figures 4.5 and 4.6).
namespace viscera::reproduction {

/// How many neighbours are tried.
void figure45(Result& result, const Bench& bench, Progress& progress);
/// How many iterations it takes.
void figure46(Result& result, const Bench& bench, Progress& progress);

} // namespace viscera::reproduction
