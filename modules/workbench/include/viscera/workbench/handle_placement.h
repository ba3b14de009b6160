#pragma once

#include <string>

#include "viscera/core/phrase.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/document/command.h"
#include "viscera/document/document.h"

/// Places handles around the organs of a document.
namespace viscera::workbench {

/// What the placed handles are called; a window gives its own language.
struct PlacementNames {
  Text step = "Place handles"; ///< The undo step.
  std::string surface = "Surface";
  std::string enclosing = "Enclosing";
};

/// Organs that are no cavity of another one; all where there is none.
document::OrganList wholeOrgans(const document::OrganList& organs);

/// The command that places handles around `chosen`, each organ by the size of its surface; the box encloses
/// all `organs`, so that every one of them can be bound. Throws as `deformation::placeHandles`.
document::Command placeHandles(const document::OrganList& chosen, const document::OrganList& organs,
                               const deformation::Placement& placement = {},
                               const PlacementNames& names = {});

/// The same around all whole organs; where their surfaces have no room for as many handles, the corners of a
/// box around them, so that no organ is refused for its handles.
document::Command placeHandlesOrBox(const document::OrganList& organs,
                                    const deformation::Placement& placement = {},
                                    const PlacementNames& names = {});

} // namespace viscera::workbench
