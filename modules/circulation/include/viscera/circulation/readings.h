#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/normal_values.h"
#include "viscera/norms/norms.h"

namespace viscera::circulation {

/// A number that is shown beside the curves, with what is normal for it.
struct Reading {
  std::string title; ///< "Stroke volume"
  std::string unit;  ///< "ml"
  int decimals = 0;  ///< That are worth showing.
  double (*of)(const Indices&) = nullptr;
  std::string norm; ///< Its row in the table of normal ranges; empty where none is agreed upon.
};

/// The numbers, in the order of a table. O(1) after the first call; thread-safe.
const std::vector<Reading>& readings();

/// What is normal for that person; nothing where none is agreed upon.
std::optional<NormalValues> normalOf(const Reading& reading, const norms::Person& person = {});

/// "60 - 100", "from 1200", "up to 120".
std::string rangeText(const NormalValues& normal, int decimals);

} // namespace viscera::circulation
