#include "cli/interior.h"

#include <algorithm>

#include "viscera/core/error.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::app::cli {

Interior interiorOf(const document::Organ& organ, const coordinates::HandleSet& handles,
                    const coordinates::CoordinateSystem& system, const coordinates::BindOptions& options,
                    const live::WitnessOptions& witnesses, std::vector<std::string>& warnings,
                    Progress& progress) {
  Interior interior;
  interior.sample = live::sampleWitnesses(*organ.mesh, witnesses, progress);
  interior.gradients = deformation::bindWitnesses(system, handles, interior.mesh().points, options, progress);
  warnings.insert(warnings.end(), interior.sample.remarks.begin(), interior.sample.remarks.end());
  const auto& failures = interior.gradients->failures();
  const auto within = std::lower_bound(failures.begin(), failures.end(), interior.mesh().witnesses);
  if (within != failures.begin())
    throw DataError(std::to_string(within - failures.begin()) +
                        " witness points have no coordinates (the first is number " +
                        std::to_string(failures.front()) + ")",
                    "handles", "enclose the organ: viscera handles ORGAN --enclosing");
  if (!failures.empty())
    warnings.push_back(std::to_string(failures.size()) +
                       " points of the surface have no coordinates; they are shown at rest.");
  return interior;
}

} // namespace viscera::app::cli
