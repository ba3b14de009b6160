#pragma once

#include "viscera/scene/organ_view.h"

namespace viscera::scene {

/// Directions of a standard view in LPS.
struct ViewDirections {
  Vec3 forward; ///< Unit, direction of sight.
  Vec3 up;      ///< Unit, to the top of the picture.
};

ViewDirections directionsOf(StandardView view);

/// How far from the middle of `bounds` a camera has to stand so that the whole box is in the picture, mm.
/// `tangent` is that of half the vertical angle of view, `aspect` width over height, `margin` (at least 1)
/// leaves room around.
double framingDistance(const Bounds& bounds, const ViewDirections& directions, double tangent, double aspect,
                       double margin);

/// The same for a parallel camera: half the height of the picture, mm.
double framingScale(const Bounds& bounds, const ViewDirections& directions, double aspect, double margin);

} // namespace viscera::scene
