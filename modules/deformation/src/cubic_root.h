#pragma once

#include <array>
#include <optional>

namespace viscera::deformation {

/// The root of `c[0] + c[1] s + c[2] s^2 + c[3] s^3` nearest to zero within |s| <= `limit`, or nothing. It
/// lies on the branch that starts at zero, so it changes continuously with the coefficients as long as it
/// exists there.
std::optional<double> nearestCubicRoot(const std::array<double, 4>& c, double limit);

} // namespace viscera::deformation
