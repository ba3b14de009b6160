#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// The thesis's numerical integration approach (3.2.1): the faces of the handles' Delaunay tetrahedra, seen
/// from a point, cover the sphere around it more than once; mean value coordinates are integrated over it at
/// the centres of a divided icosahedron. A sample is shared between all triangles that hold it, as the square
/// of the volume that each spans with the point.
///
/// Each sample is reproduced by every triangle that holds it, and the samples add up to zero, so identity and
/// unity are exact for any number of samples. The integral is continuous; its sum jumps where a sample passes
/// an edge, by less the more samples there are. `samples` is the number of divisions of the icosahedron,
/// `seed` turns it at random; 0 leaves it as it is. O(samples x tetrahedra) a point.
class NumericalIntegration final : public PointwiseSystem {
public:
  NumericalIntegration();
};

} // namespace viscera::coordinates
