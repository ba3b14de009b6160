#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/stiff_bodies.h"
#include "viscera/document/document.h"
#include "viscera/document/organ.h"

namespace viscera::live {

/// Binds an organ to handles so that it follows them as its mobility says: by its coordinates, as a rigid
/// body, or not at all. Throws as `deformation::bindOrgan`, but never for an organ that stays in place.
std::shared_ptr<const coordinates::Binding> bindMovable(const document::Organ& organ,
                                                        const coordinates::CoordinateSystem& system,
                                                        const coordinates::HandleSet& handles,
                                                        const coordinates::BindOptions& options,
                                                        Progress& progress);

/// The organs that do not bend, in their order: rigid ones and those that stay in place.
std::vector<std::shared_ptr<const document::Organ>> stiffOrgans(const document::OrganList& organs);

/// The surfaces of such organs, for a warped scan in which they do not bend either. Throws `Cancelled`.
std::shared_ptr<deformation::StiffBodies>
stiffBodies(const std::vector<std::shared_ptr<const document::Organ>>& organs, Threads threads,
            Progress& progress);

} // namespace viscera::live
