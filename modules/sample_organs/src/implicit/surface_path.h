#pragma once

#include <vector>

#include "implicit/tube_axis.h"

namespace viscera::sample_organs {

/// The path of a vessel over a surface, with its radii.
struct SurfacePath {
  std::vector<Vec3> points; ///< A few rough points near the surface, mm; at least two.
  double startRadius = 2;   ///< mm
  double endRadius = 1;     ///< mm
  double lift = 0.2;        ///< How far the axis lies above the surface, in radii; negative: sunk in.
  double fadeIn = 0;        ///< Over these first mm of its length it rises out of the surface ...
  double fadeOut = 0;       ///< ... and over these last it sinks back and thins out.
  int smoothing = 4;        ///< Rounds of smoothing along the surface.
  NodePtr between[2];       ///< When given, the path keeps to the groove where these two are equally far.
};

/// The axis of a vessel on `base`, dense enough for a tube; empty when the path shrinks to a point.
std::vector<AxisPoint> axisOnSurface(const ImplicitNode& base, const SurfacePath& path);

} // namespace viscera::sample_organs
