#pragma once

#include <limits>
#include <string>

#include "viscera/core/phrase.h"

namespace viscera::circulation {

/// The normal range of a number in healthy adults at rest, in the unit of that number.
struct NormalValues {
  double low = -std::numeric_limits<double>::infinity(); ///< Minus infinity: no lower bound.
  double high = std::numeric_limits<double>::infinity();
  std::string source; ///< The source of the range.
  /// The definition of a range of the table of `anatomy`, and the people that were measured. Two
  /// texts, so that each can be translated.
  Text meaning = {};
  std::string people = {};

  bool holds(double value) const { return value >= low && value <= high; }
};

} // namespace viscera::circulation
