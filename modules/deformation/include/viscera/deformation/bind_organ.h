#pragma once

#include <memory>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// Binds an organ to handles and does not accept a partial answer. Throws what the system throws, and
/// `DataError` when vertices have no coordinates: how many, the first of them, how far out, and that
/// enclosing handles help.
std::shared_ptr<const coordinates::Binding>
bindOrgan(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
          const Points& organPoints, const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::deformation
