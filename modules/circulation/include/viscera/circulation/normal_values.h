#pragma once

#include <limits>
#include <string>

namespace viscera::circulation {

/// The normal range of a number in healthy adults at rest, in the unit of that number.
struct NormalValues {
  double low = -std::numeric_limits<double>::infinity(); ///< Minus infinity: no lower bound.
  double high = std::numeric_limits<double>::infinity();
  std::string source; ///< Who says so.
  /// Of a row of the table of `norms`: how the range comes about, and who was measured. Each is a text of its
  /// own, so that it can be translated.
  std::string meaning = {}, people = {};

  bool holds(double value) const { return value >= low && value <= high; }
};

} // namespace viscera::circulation
