#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// C-Celestial coordinates: the centroid of the positive balanced vectors within the unit sphere, by sampling
/// (thesis 4.2). `sampling`:
/// * `hit-and-run` (ours): a walk inside the cone and the unit ball, which loses no sample;
/// * `sphere`, `cube`: as the thesis, random vectors projected, those with a negative number thrown away.
/// With
///   many handles almost all are, and a point may be left without coordinates.
///
/// `samples` a point, and `seed`; every point uses the same random numbers. O(samples x n) a point.
class CCelestial final : public PointwiseSystem {
public:
  CCelestial();
};

} // namespace viscera::coordinates
