#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::localised_scc {

/// A number in [0, 1] at a point and its derivative there.
struct BlendValue {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
};

/// The thesis's blending curve (4.5) `rho(t) = (1 - t)^3 + 3 (1 - t)^2 t`, t = d / h, for a point at distance
/// d (mm) in the unit direction `away` from a zone; 1 in the zone, 0 from h on, and C1 in between and across
/// both ends.
BlendValue blendAt(double distance, const Vec3& away, double offset);

/// The weights of several zones and (last) of the region itself: `rho_k prod_{l != k} (1 - rho_l)` and `prod
/// (1 - rho_l)`, divided by their sum. Continuous as long as at most one rho is 1 at a time.
std::vector<BlendValue> partition(const std::vector<BlendValue>& zones);

} // namespace viscera::localised_scc
