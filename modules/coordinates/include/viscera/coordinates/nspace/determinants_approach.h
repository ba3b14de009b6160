#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Coordinates by determinants: the mean of the balanced vectors of all tetrahedra of handles that contain
/// the point, each divided by its norm (thesis 3.3.3). Positive; jumps where the number of tetrahedra
/// changes. O(n^4) a point.
class DeterminantsApproach final : public PointwiseSystem {
public:
  DeterminantsApproach();
};

} // namespace viscera::coordinates
