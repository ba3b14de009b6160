#pragma once

#include "viscera/core/arrays.h"
#include "viscera/elasticity/elastic_body.h"

namespace viscera::elasticity {

/// The von Mises stress of a body over its volume at rest, kPa.
struct TissueStress {
  double mean = 0;
  double p95 = 0; ///< Below it is the stress in 95 % of the volume.
  double max = 0; ///< Over the quadrature points.
};

/// The stress of `body` at `state`, the unknowns of a `StaticSolution`. O(tetrahedra log tetrahedra).
TissueStress tissueStress(const ElasticBody& body, const Values& state);

} // namespace viscera::elasticity
