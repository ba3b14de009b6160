#pragma once

#include <algorithm>
#include <cmath>

#include "viscera/heart/heart_rig.h"

namespace viscera::heart::test {

/// Negative inside an ellipsoid with axes along those of the world; not quite a distance.
inline sequences::AnatomySurface ellipsoid(const Vec3& center, const Vec3& radii) {
  return [=](const Vec3& p) {
    const double k = (p - center).cwiseQuotient(radii).norm();
    return (k - 1) * radii.minCoeff();
  };
}

/// A heart out of ellipsoids whose frame is that of the world: axis along z, right ventricle towards x.
inline HeartAnatomy simpleHeart() {
  HeartAnatomy heart;
  heart.endocardium = {25, 28, 59};
  heart.epicardium = {36, 30, 67};
  heart.baseEpicardium = -6;
  heart.length = 92;
  const sequences::AnatomySurface left = ellipsoid({0, 0, 30}, {36, 36, 67});
  const sequences::AnatomySurface right = ellipsoid({27, 0, 28}, {40, 44, 57});
  const sequences::AnatomySurface rightInside = ellipsoid({27, 0, 28}, {36, 40, 53});
  heart.ventricles = [=](const Vec3& p) { return std::min(left(p), right(p)); };
  heart.rightCavity = [=](const Vec3& p) { return std::max(rightInside(p), -left(p)); };
  heart.greatVessels = ellipsoid({0, 0, -120}, {20, 20, 40});
  heart.atria = {{ellipsoid({30, 0, -35}, {25, 25, 28}), {30, 0, -35}, {}}};
  heart.vessels = {{{0, 0, -165}, {0, 0, 1}, 0, 1, 0}, {{0, 0, -80}, {0, 0, 1}, 22, 4, 0.5}};
  heart.box = {{-120, -120, -200}, {140, 120, 150}};
  return heart;
}

} // namespace viscera::heart::test
