#pragma once

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// Sample directions on the unit sphere with their solid angles.
struct SphereSamples {
  Eigen::Matrix3Xd directions; ///< `3 x 20 * 4^level` unit vectors: triangles' centres.
  Values areas;                ///< Sum to 4 pi; `sum area * direction` is zero by symmetry.
};

/// The triangles of an icosahedron divided `level` times (thesis, figure 3.18).
SphereSamples sphereSamples(int level);

} // namespace viscera::coordinates
