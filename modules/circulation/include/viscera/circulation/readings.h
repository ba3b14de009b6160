#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/normal_values.h"

namespace viscera::circulation {

/// A number that is shown beside the curves, with what is normal for it.
struct Reading {
  std::string title; ///< "Stroke volume"
  std::string unit;  ///< "ml"
  int decimals = 0;  ///< That are worth showing.
  double (*of)(const Indices&) = nullptr;
  std::optional<NormalValues> normal; ///< Nothing where none is agreed upon.
};

/// The numbers, in the order of a table. O(1) after the first call; thread-safe.
const std::vector<Reading>& readings();

/// "60 - 100", "from 1200", "up to 120".
std::string rangeText(const NormalValues& normal, int decimals);

} // namespace viscera::circulation
