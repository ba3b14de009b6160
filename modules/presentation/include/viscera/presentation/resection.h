#pragma once

#include <vector>

#include "viscera/document/document.h"
#include "viscera/document/measured_values.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/tissue_actor.h"

namespace viscera::presentation {

/// The plane of a cut through a document: its offset refers to the ball around the visible organs at rest, so
/// that the plane stands still while they move. O(points).
scene::CutPlane planeOf(const OrganCut& cut, const document::DocumentState& state);

/// What the cut leaves of an organ, and what it takes away.
struct Resected {
  document::OrganId organ;
  double staysMl = 0;
  double cutAwayMl = 0;
  double faceCm2 = 0; ///< Area of the organ in the plane.
};

/// The visible, closed organs that the cut's plane goes through, in the document's order, with the volumes
/// of both sides in their present places (`geometry::sidesOfPlane`). A cavity counts as an organ of its own
/// and is not taken from the one around it. O(points + triangles).
std::vector<Resected> resected(const OrganCut& cut, const document::DocumentState& state,
                               const document::PointsOf& pointsOf);

} // namespace viscera::presentation
