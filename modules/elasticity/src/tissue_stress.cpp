#include "viscera/elasticity/tissue_stress.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "viscera/elasticity/tissues.h"

namespace viscera::elasticity {

TissueStress tissueStress(const ElasticBody& body, const Values& state) {
  std::vector<std::pair<double, double>> samples; // Stress and volume.
  TissueStress stress;
  for (Eigen::Index t = 0; t < body.mesh().tetrahedra.rows(); ++t)
    for (const LocalState& at : body.statesOf(t, state)) {
      samples.emplace_back(vonMisesKpa(body.material(), at.gradient), at.weightMm3);
      stress.mean += samples.back().first * at.weightMm3 / body.volumeMm3();
    }
  std::sort(samples.begin(), samples.end());
  stress.max = samples.back().first;
  double volume = 0;
  for (const auto& [value, part] : samples)
    if ((volume += part) <= 0.95 * body.volumeMm3())
      stress.p95 = value;
  return stress;
}

} // namespace viscera::elasticity
