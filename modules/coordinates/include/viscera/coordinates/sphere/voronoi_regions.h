#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates over the triangulated Voronoi regions of the handles on the sphere around each
/// point; the weights of the Voronoi vertices are passed on to the handles (thesis 3.1.2). `transfer`:
/// * `spherical-barycentric`: to the three handles whose triangle the vertex belongs to; jumps at flips.
/// * `natural-neighbour`: to the natural neighbours in the plane that touches the sphere at the vertex, by a
///   polar projection; jumps where the point is in line with two handles (a sword).
/// * `laguerre`: natural neighbours again, with the diagrams weighted by distance. The thesis does not print
///   its weights. Ours: a handle lies at `q_i D / d_i` (D the largest distance) instead of q_i for the
///   diagram on the sphere, and has the power `-d_i / D` in the plane. Power diagrams keep the linear
///   precision (Aurenhammer 1988, doi 10.1137/0401036).
///
/// Points at which a vertex has no natural neighbours all around have no coordinates. A hull of n points and
/// O(n^3) for the transfer a point.
class VoronoiRegions final : public PointwiseSystem {
public:
  VoronoiRegions();
};

} // namespace viscera::coordinates
