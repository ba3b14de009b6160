#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// C-Celestial coordinates: the centroid of the positive balanced vectors within the unit sphere, by sampling
/// (thesis 4.2). `sampling`:
/// * `hit-and-run` (ours): a walk inside the cone and the unit ball, which loses no sample;
/// * `sphere`, `cube`: as in the thesis, random vectors are projected, and those with a negative number
///   rejected. With many handles almost all are rejected, and a point may have no coordinates.
///
/// `samples` a point, and `seed`; every point uses the same random numbers. O(samples x n) a point.
class CCelestial final : public PointwiseSystem {
public:
  CCelestial();
};

} // namespace viscera::coordinates
