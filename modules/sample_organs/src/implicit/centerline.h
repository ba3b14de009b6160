#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::sample_organs {

/// A point of a tube's axis as a definition gives it.
struct AxisPoint {
  Vec3 position;     ///< mm
  double radius = 0; ///< mm
};

/// A point of the sampled axis, with a frame that turns as little as possible along it.
struct AxisSample {
  Vec3 position = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  Vec3 binormal = Vec3::Zero();
  double radius = 0; ///< mm
  double arc = 0;    ///< Length of the axis up to here, mm.
};

/// Samples a smooth axis through `points` (at least two, neighbours apart) about every `step` mm: a
/// centripetal Catmull-Rom spline (Yuksel et al. 2011, 10.1016/j.cad.2010.08.008), which neither loops nor
/// overshoots between uneven points; the radius is interpolated without overshoot. The first normal lies as
/// near `firstNormal` as it can.
std::vector<AxisSample> sampleAxis(const std::vector<AxisPoint>& points, double step,
                                   const Vec3& firstNormal);

} // namespace viscera::sample_organs
