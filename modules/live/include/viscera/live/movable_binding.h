#pragma once

#include <memory>

#include "viscera/coordinates/binding.h"
#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/progress.h"
#include "viscera/document/organ.h"

namespace viscera::live {

/// Binds an organ to handles so that it follows them as its mobility says: by its coordinates, as a rigid
/// body, or not at all. Throws as `deformation::bindOrgan`, but never for an organ that stays in place.
std::shared_ptr<const coordinates::Binding> bindMovable(const document::Organ& organ,
                                                        const coordinates::CoordinateSystem& system,
                                                        const coordinates::HandleSet& handles,
                                                        const coordinates::BindOptions& options,
                                                        Progress& progress);

} // namespace viscera::live
