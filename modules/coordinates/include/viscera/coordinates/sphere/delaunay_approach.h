#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates over the Delaunay triangulation of the handles on the sphere around each point
/// (thesis 3.1.1). They jump where an edge of the triangulation flips. `blend` (degrees, 0 for none) mixes in
/// the flipped pair of triangles from where the two angles across an edge sum up to 180 degrees less `blend`,
/// with a share that rises from 0 to one half at the flip by a cubic without slope at its ends. (The thesis's
/// control points of that cubic do not meet in the middle; these do.) If several edges are near a flip at
/// once, the shares of those that are farther from it are reduced, so that the coordinates are continuous at
/// a flip and all shares stay positive. A wide blend may still jump where more flips coincide. One hull of n
/// points a point.
class DelaunayApproach final : public PointwiseSystem {
public:
  DelaunayApproach();
};

} // namespace viscera::coordinates
