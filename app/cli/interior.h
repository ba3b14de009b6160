#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/inputs.h"
#include "viscera/coordinates/coordinate_system.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::app::cli {

/// An organ's inside, ready for any pose of its handles.
struct Interior {
  live::WitnessSample sample;
  std::shared_ptr<const deformation::WitnessGradients> gradients; ///< At all points of the sample's mesh.

  const deformation::WitnessMesh& mesh() const { return *sample.mesh; }
};

/// Fills an organ with witness points and ties them to handles. Adds to `warnings` how the points came about
/// and which points of the skin have no coordinates. Throws what sampling and binding throw, and `DataError`
/// when witness points have no coordinates: they would pass for points without stress.
Interior interiorOf(const document::Organ& organ, const coordinates::HandleSet& handles,
                    const coordinates::CoordinateSystem& system, const coordinates::BindOptions& options,
                    const live::WitnessOptions& witnesses, std::vector<std::string>& warnings,
                    Progress& progress);

} // namespace viscera::app::cli
