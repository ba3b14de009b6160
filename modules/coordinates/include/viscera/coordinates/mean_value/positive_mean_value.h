#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates computed from only the part of the cage that is visible from the point (thesis 2.3;
/// Lipman, Kopf, Cohen-Or, Levin 2007, Symposium on Geometry Processing): positive in any cage. By rays to
/// the centres of an icosahedron's triangles divided `level` times, weighted by areas; their symmetry makes
/// the identity exact. The coordinates jump a little where a ray moves to another triangle. O(rays x
/// triangles) a point.
class PositiveMeanValue final : public PointwiseSystem {
public:
  PositiveMeanValue();
};

} // namespace viscera::coordinates
