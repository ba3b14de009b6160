#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/coordinates/registry.h"
#include "viscera/deformation/selection_motion.h"
#include "viscera/document/document.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/region_hulls.h"

/// Computes the shapes that the 3D view draws beside organs and handles: regions, cages and mirror planes.
namespace viscera::presentation {

/// The current organ, to which commands and pictures refer: the selected one, else the first that is not a
/// cavity of another organ; null without organs. O(organs).
std::shared_ptr<const document::Organ> currentOrgan(const document::DocumentState& state,
                                                    document::OrganId selected);

/// The traits of the chosen coordinate system; the default traits when it is not available.
coordinates::Traits traitsOf(const document::DocumentState& state, const coordinates::Registry& systems);

/// How the coordinates of a document divide the space around its handles at rest; empty when they treat all
/// space alike, are not available, or cannot use these handles or groups. About a millisecond.
coordinates::SpaceLayout layoutOf(const document::DocumentState& state, const coordinates::Registry& systems);

/// The hulls that are drawn for a layout over handles at rest, in the colours of the groups; with the regions
/// also the cage, for coordinates that need one.
std::vector<scene::RegionHull> regionHulls(const document::DocumentState& state,
                                           const scene::LayoutParts& shown,
                                           const coordinates::Registry& systems);

/// The plane that drags are mirrored at, through the middle of the current organ at rest; none without an
/// organ or a mirror.
std::optional<deformation::MirrorPlane> mirrorPlaneOf(const document::DocumentState& state,
                                                      document::OrganId selected, Mirror mirror);

} // namespace viscera::presentation
