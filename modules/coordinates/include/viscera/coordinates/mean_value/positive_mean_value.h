#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates of a cage of which only what can be seen from the point counts (thesis 2.3; Lipman,
/// Kopf, Cohen-Or, Levin 2007, Symposium on Geometry Processing): positive in any cage. By rays to the
/// centres of an icosahedron's triangles divided `level` times, weighted by areas; their symmetry makes the
/// identity exact. The coordinates jump a little where a ray hops to another triangle. O(rays x triangles) a
/// point.
class PositiveMeanValue final : public PointwiseSystem {
public:
  std::string id() const override { return "positive-mean-value"; }
  std::string name() const override { return "Positive mean value"; }
  std::string summary() const override;
  Traits traits() const override;
  std::vector<Parameter> parameters() const override;

protected:
  std::unique_ptr<const PointSolver> prepare(const HandleSet& handles,
                                             const ParameterValues& parameters) const override;
};

} // namespace viscera::coordinates
