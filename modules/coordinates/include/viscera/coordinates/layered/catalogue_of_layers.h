#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// The mean of mean value coordinates over several layers (thesis 3.2.2): the convex hull of the handles, and
/// partitions of it by the inner handles. `partitions`: `nested`, one partition by all inner handles one
/// after another; or `independent`, one for each. `polyhedra`: `tetrahedra`, or `convex`, where neighbours
/// are joined as long as their union is convex. Kinks at the faces inside. The thesis's other inner system,
/// harmonic coordinates, is not offered. O(polyhedra + triangles) a point.
class CatalogueOfLayers final : public PointwiseSystem {
public:
  CatalogueOfLayers();
};

} // namespace viscera::coordinates
