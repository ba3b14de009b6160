#pragma once

#include <optional>
#include <string>

#include "viscera/deformation/witness_gradients.h"

namespace viscera::python {

/// A quantity of a stress map that needs a material.
enum class StressOfMaterial { vonMises, energy };

/// It at every point of a map, kPa; NaN where the tissue is folded. Throws `UsageError` without a material,
/// and for one that is not known.
Values ofMaterial(const deformation::StressMap& map, const std::optional<std::string>& tissue,
                  std::optional<double> youngKpa, double poisson, StressOfMaterial which);

} // namespace viscera::python
