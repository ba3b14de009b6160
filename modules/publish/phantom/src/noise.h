#pragma once

#include <cstdint>

#include "viscera/core/arrays.h"

namespace viscera::phantom {

/// A number that depends on all of its arguments and on nothing else: no result depends on the order in which
/// voxels are filled.
std::uint64_t mixed(std::uint64_t a, std::uint64_t b, std::uint64_t c = 0, std::uint64_t d = 0);

/// Two independent numbers of a normal distribution with a deviation of 1.
Eigen::Vector2d normalPair(std::uint64_t seed);

/// Smooth grain with a mean of 0 and a deviation of about 1, fixed to places at rest (mm): numbers at a
/// lattice of 6 mm and, half as strong, of 3 mm, smooth in between. O(1), 0.2 microseconds.
double grainAt(const Vec3& rest, std::uint64_t seed);

/// The magnitude of a complex signal, both of whose parts have noise of that deviation (Rician distribution;
/// Gudbjartsson and Patz 1995, doi 10.1002/mrm.1910340618).
double ricianOf(double signal, double deviation, std::uint64_t seed);

} // namespace viscera::phantom
