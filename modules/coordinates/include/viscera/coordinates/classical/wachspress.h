#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Wachspress coordinates of a convex cage (thesis 2.3; Warren 1996, doi 10.1007/BF02127699; in this form
/// Floater, Gillette, Sukumar 2014, doi 10.1137/130925712). With `p_f = n_f / h_f` for the faces around a
/// corner, in order, and h the distances to their planes, the corner's weight is the sum of
/// `det(p_1, p_j, p_j+1)`: rational functions, positive and smooth inside. The cage is `HandleSet::cage`,
/// else the convex hull of the handles. Throws `DataError` for a cage that is not convex. O(triangles) a
/// point.
class Wachspress final : public PointwiseSystem {
public:
  Wachspress();
};

} // namespace viscera::coordinates
