#pragma once

#include "viscera/coordinates/celestial/celestial_system.h"

namespace viscera::coordinates {

/// S-Celestial coordinates (thesis 4.4): `sum mu_i^2 q_i = 0`, mu_i the distance from the point to the sphere
/// of centre c and radius lambda + |c| along q_i.
///
/// With `s^2 = lambda^2 + 2 lambda |c|` and `x = c / s` this is the convex problem of `CelestialSystem` with
/// `phi'(t) = (t + sqrt(t^2 + 1))^2`: `mu_i = s (t_i + sqrt(t_i^2 + 1))`, and the factor s cancels. So
/// **lambda changes nothing**; the parameter is accepted because users of the thesis expect it.
class SCelestial final : public CelestialSystem {
public:
  SCelestial();
};

} // namespace viscera::coordinates
