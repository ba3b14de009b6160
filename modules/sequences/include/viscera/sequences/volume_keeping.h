#pragma once

#include <array>
#include <functional>
#include <optional>

#include "viscera/core/arrays.h"

namespace viscera::sequences {

/// The volume of an organ whose handles are at `pose + x direction` (both `n x 3`), as the coefficients of 1,
/// x, x^2 and x^3, ml. Coordinates that are linear in the pose make it just that, exactly. May be asked from
/// several threads.
using VolumeAlong = std::function<std::array<double, 4>(const Points& pose, const Points& direction)>;

/// The x nearest to `guess` within [low, high] at which the cubic has the value `target`, to rounding;
/// nothing when there is none. Newton's method, kept inside a bracket.
std::optional<double> solveCubic(const std::array<double, 4>& cubic, double target, double guess, double low,
                                 double high);

} // namespace viscera::sequences
