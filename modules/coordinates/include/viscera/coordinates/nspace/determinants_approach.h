#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// The mean of the balanced vectors of all tetrahedra of handles that contain the point, each divided by its
/// norm (thesis 3.3.3). Positive; jumps where the number of tetrahedra changes. O(n^4) a point.
class DeterminantsApproach final : public PointwiseSystem {
public:
  std::string id() const override { return "determinants-approach"; }
  std::string name() const override { return "Determinants approach"; }
  std::string summary() const override;
  Traits traits() const override;
  std::vector<Parameter> parameters() const override;

protected:
  std::unique_ptr<const PointSolver> prepare(const HandleSet& handles,
                                             const ParameterValues& parameters) const override;
};

} // namespace viscera::coordinates
