#pragma once

#include "viscera/core/arrays.h"

namespace viscera::scene {
class OrganView;
}

namespace viscera::app {

/// Turns the camera around what it looks at until the face of a cut can be seen, where it is now seen edge-on
/// or from behind; else the camera stays. `normal` is the unit normal of the cut, which points into what is
/// kept. The distance of the camera stays, and what is up stays up as far as possible. The caller renders.
void seeCut(scene::OrganView& view, const Vec3& normal);

/// The direction from which a cut with that normal is seen: `sight` itself where it meets the face at an
/// angle that shows it, else one that is turned towards the face in the plane of both. Both are unit vectors,
/// and so is the result.
Vec3 sightOfCut(const Vec3& sight, const Vec3& normal);

} // namespace viscera::app
