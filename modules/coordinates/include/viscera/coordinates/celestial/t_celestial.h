#pragma once

#include "viscera/coordinates/celestial/celestial_system.h"

namespace viscera::coordinates {

/// T-Celestial coordinates (thesis 4.3): `sum exp(psi . q_i) q_i = 0`, the convex problem of
/// `CelestialSystem` with `phi(t) = exp(t)`. The thesis calls them dependent on rotation; solved to the end
/// they are not (the tests measure it).
class TCelestial final : public CelestialSystem {
public:
  TCelestial();
};

} // namespace viscera::coordinates
