#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Sibson's natural neighbour coordinates (thesis 3.1.2, end; Sibson 1981; Boissonnat, Cazals 2001): the
/// shares of the point's Voronoi cell that it takes from the cells of the handles. Positive, local, smooth
/// but at the handles. Cells are cut from half spaces without geometric predicates, so that handles on one
/// sphere cause no problems. O(n + k^2) cuts a point with k natural neighbours.
class NaturalNeighbours final : public PointwiseSystem {
public:
  NaturalNeighbours();
};

} // namespace viscera::coordinates
