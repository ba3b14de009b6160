#pragma once

#include <cstddef>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/geometry/plane_cut.h"

namespace viscera::tracking {

/// Corrected contours that are as near as this to the surface's cut in all their points are met, mm.
constexpr double kCorrectionMetMm = 0.3;

/// A contour that a user corrected in one plane at one phase: the surface passes through its points there,
/// whatever the images show.
struct CorrectedContour {
  std::size_t phase = 0;
  std::size_t surface = 0; ///< Of the rig.
  geometry::Plane plane;
  Points points; ///< `k x 3` mm in that plane, along the contour.
};

/// What became of a corrected contour. Distances are those of its points from the surface's cut by the plane,
/// the largest of them, mm.
struct CorrectionMet {
  double beforeMm = 0; ///< Without corrections.
  double mostMm = 0;   ///< With all of them.
  /// The tissue would have folded, so that it is met in part only.
  bool heldBack = false;

  bool met() const { return mostMm <= kCorrectionMetMm; }
};

} // namespace viscera::tracking
