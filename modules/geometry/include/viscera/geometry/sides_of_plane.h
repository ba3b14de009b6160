#pragma once

#include "viscera/core/arrays.h"
#include "viscera/geometry/plane_cut.h"

namespace viscera::geometry {

/// What a plane makes of a closed surface: the volumes of both sides and the face between them.
struct SidesOfPlane {
  double frontMm3 = 0; ///< On the side that the plane's normal points to; signed, as `volume` is.
  double backMm3 = 0;
  double faceMm2 = 0; ///< Area of the surface's inside in the plane.

  /// Whether both sides have a part of the surface.
  bool cuts() const { return frontMm3 != 0 && backMm3 != 0; }
};

/// Clips every triangle of a closed surface by a plane and sums the volumes of both sides, exactly but for
/// rounding, for surfaces of any shape and number of parts: the face that would close a side lies in the
/// plane, so its cone from a point of the plane has no volume. Meaningless for an open surface. O(m), without
/// memory; deterministic.
SidesOfPlane sidesOfPlane(const SurfaceView& surface, const Plane& plane);

} // namespace viscera::geometry
