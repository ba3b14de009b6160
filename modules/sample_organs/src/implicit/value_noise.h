#pragma once

#include "viscera/core/arrays.h"

namespace viscera::sample_organs {

/// Smooth noise in [-1, 1]: a random value for every point of the integer lattice, blended by quintics (two
/// continuous derivatives). The same `seed` gives the same noise everywhere.
double valueNoise(const Vec3& point, int seed);

} // namespace viscera::sample_organs
