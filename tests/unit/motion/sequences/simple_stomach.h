#pragma once

#include <algorithm>
#include <cmath>

#include "viscera/sequences/stomach_rig.h"

namespace viscera::sequences::test {

/// A straight stomach along -z that narrows from 40 to 10 mm, its top at the origin.
inline double simpleRadius(double s) {
  return 40 - 30 * std::clamp((s - 60) / 200, 0.0, 1.0);
}

inline StomachAnatomy simpleStomach() {
  StomachAnatomy stomach{Centerline({{0, 0, 0}, {0, 0, -100}, {0, 0, -200}, {0, 0, -320}}), {}, {}, {}, {}};
  stomach.course = {100, 270};
  stomach.surface = [](const Vec3& p) {
    return std::max(std::hypot(p.x(), p.y()) - simpleRadius(-p.z()), std::max(p.z(), -310 - p.z()));
  };
  stomach.fixed = {{{0, 0, 14}, {0, 0, 1}, 0, 1}, {{0, 0, -300}, {0, 0, 1}, 20, 5}};
  stomach.box = {{-120, -120, -400}, {120, 120, 100}};
  return stomach;
}

} // namespace viscera::sequences::test
