#pragma once

#include <memory>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::deformation {

/// The derivatives of the coordinates at `points` (`n x 3`, the points of a witness mesh), taken in portions
/// so that memory holds them once only: `n x handles x 24` bytes. Reports progress and may be cancelled
/// between the portions. Points without coordinates are in the result's failures. Throws what
/// `coordinates::CoordinateSystem::gradients` throws.
std::shared_ptr<const WitnessGradients>
bindWitnesses(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
              const Points& points, const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::deformation
