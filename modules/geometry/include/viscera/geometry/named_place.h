#pragma once

#include <string>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A place on a surface that has a name in anatomy, such as the apex of the heart.
struct NamedPlace {
  std::string name;       ///< English, UTF-8; shown translated.
  Vec3 at = Vec3::Zero(); ///< mm, LPS, on the surface at rest or near it.
  double ringMm = 0;      ///< Of a valve: the radius of its ring, mm; 0: the place is a point.

  friend bool operator==(const NamedPlace&, const NamedPlace&) = default;
};

} // namespace viscera::geometry
