#pragma once

#include "viscera/presentation/view_state.h"
#include "viscera/scene/organ_view.h"

namespace viscera::presentation {

/// Where the eye of a view is.
Camera cameraOf(const scene::OrganView& view);

/// Puts it there. A camera that looks nowhere (position and focus are one place) changes nothing.
void lookFrom(const Camera& camera, scene::OrganView& view);

} // namespace viscera::presentation
