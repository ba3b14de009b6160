#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates of a cage with polygons (thesis 2.3; Langer, Belyaev, Seidel 2006, Symposium on
/// Geometry Processing): triangles of the cage that lie in one plane, to 1e-9 of its size, are one face, and
/// its mean vector is shared among its corners by mean value coordinates on the sphere. Over triangles it is
/// the same as mean value coordinates; over a face of four corners the cage's diagonals play no part.
/// O(triangles) a point.
class SphericalMeanValue final : public PointwiseSystem {
public:
  SphericalMeanValue();
};

} // namespace viscera::coordinates
