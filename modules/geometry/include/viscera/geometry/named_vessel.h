#pragma once

#include <string>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A vessel on or in an organ that has a name in anatomy, such as a coronary artery, as a line with radii.
struct NamedVessel {
  std::string name;          ///< English, UTF-8; shown translated. Several may share one.
  Vec3 color = Vec3::Ones(); ///< Red green blue, 0 to 1.
  Points axis;               ///< `n x 3`, mm, LPS, at rest; two at least.
  Values radii;              ///< `n`, mm.
  bool inWall = false;       ///< It runs in the organ, so that only a cut shows it.
};

} // namespace viscera::geometry
