#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Sibson's natural neighbour coordinates (thesis 3.1.2, end; Sibson 1981; Boissonnat, Cazals 2001): the
/// shares of the point's Voronoi cell that it takes from the cells of the handles. Positive, local, smooth
/// but at the handles. Cells are cut from half spaces and nothing is decided by a test, so that handles on
/// one sphere do no harm. O(n + k^2) cuts a point with k natural neighbours.
class NaturalNeighbours final : public PointwiseSystem {
public:
  std::string id() const override { return "natural-neighbours"; }
  std::string name() const override { return "Natural neighbours"; }
  std::string summary() const override;
  Traits traits() const override;
  std::vector<Parameter> parameters() const override;

protected:
  std::unique_ptr<const PointSolver> prepare(const HandleSet& handles,
                                             const ParameterValues& parameters) const override;
};

} // namespace viscera::coordinates
