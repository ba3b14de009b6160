#pragma once

#include <array>
#include <optional>

namespace viscera {

/// The root of `c[0] + c[1] s + c[2] s^2 + c[3] s^3` nearest to zero within `low` <= s <= `high` (low <= 0 <=
/// high), to rounding, or nothing when there is none. It lies on the branch that starts at zero, so it
/// changes continuously with the coefficients as long as it exists there. Newton's method inside a bracket;
/// from any thread.
std::optional<double> nearestCubicRoot(const std::array<double, 4>& c, double low, double high);

} // namespace viscera
