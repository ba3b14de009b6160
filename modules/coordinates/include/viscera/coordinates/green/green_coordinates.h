#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Green coordinates (Lipman, Levin and Cohen-Or 2008, doi 10.1145/1360612.1360677): inside a closed cage of
/// any shape a point is a sum of the cage's corners and of its triangles' normals, by Green's third identity.
/// In a pose the normals are those of the posed cage, scaled by the stretch of their triangles.
///
/// They reproduce every point at rest and follow every similarity; they do not follow other affine motions,
/// and do not interpolate handles; in return they nearly keep angles. The points are not linear in the pose,
/// so the volume is no cubic along a motion of the handles and a lock works by Newton steps. Coordinates in
/// closed form, by solid angles and logarithms of the edges, which is the same integral as in the paper; with
/// derivatives. Points outside the cage have no coordinates: the continuation through a face of the paper's
/// section 6 is left out. O(triangles) a point.
class GreenCoordinates final : public PointwiseSystem {
public:
  GreenCoordinates();
};

} // namespace viscera::coordinates
