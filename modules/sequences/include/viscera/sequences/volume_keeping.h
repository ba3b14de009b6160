#pragma once

#include <array>
#include <functional>

#include "viscera/core/arrays.h"

namespace viscera::sequences {

/// The volume of an organ whose handles are at `pose + x direction` (both `n x 3`), as the coefficients of 1,
/// x, x^2 and x^3, ml. Coordinates that are linear in the pose make it just that, exactly. May be asked from
/// several threads.
using VolumeAlong = std::function<std::array<double, 4>(const Points& pose, const Points& direction)>;

} // namespace viscera::sequences
