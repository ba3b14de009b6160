#pragma once

#include <string>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A line along an organ that has a name in anatomy and that an excitation runs along, such as a branch of
/// the heart's conduction system.
struct NamedWay {
  std::string name;   ///< English, UTF-8; shown translated. Several ways may share one.
  double widthMm = 1; ///< The radius that it is drawn with.
  Points points;      ///< `n x 3`, mm, LPS, at rest; two at least.
  Values reachedMs;   ///< `n`, ascending: when the excitation is there, ms after it began.

  friend bool operator==(const NamedWay& a, const NamedWay& b) {
    return a.name == b.name && a.widthMm == b.widthMm && a.points.rows() == b.points.rows() &&
           a.points == b.points && a.reachedMs == b.reachedMs;
  }
};

} // namespace viscera::geometry
