#pragma once

#include <limits>
#include <string>

namespace viscera::circulation {

/// What healthy adults at rest have, in the unit of the number that it belongs to.
struct NormalValues {
  double low = -std::numeric_limits<double>::infinity(); ///< Minus infinity: no lower bound.
  double high = std::numeric_limits<double>::infinity();
  std::string source; ///< Who says so.

  bool holds(double value) const { return value >= low && value <= high; }
};

} // namespace viscera::circulation
