#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/anatomy/norms.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/normal_values.h"
#include "viscera/core/phrase.h"

namespace viscera::circulation {

/// A number of the circulation as tables show it: name, unit, decimals and normal range.
struct Reading {
  std::string title; ///< "Stroke volume"
  std::string unit;  ///< "ml"
  int decimals = 0;  ///< That are worth showing.
  double (*of)(const Indices&) = nullptr;
  std::string norm; ///< Its row in the table of normal ranges; empty where none is agreed upon.
};

/// All numbers of the circulation that tables show, in their order. O(1) after the first call; thread-safe.
const std::vector<Reading>& readings();

/// The normal range of a number for a person; nothing where no range is agreed upon.
std::optional<NormalValues> normalOf(const Reading& reading, const anatomy::Person& person = {});

/// "60 - 100", "from 1200", "up to 120".
Text rangeText(const NormalValues& normal, int decimals);

} // namespace viscera::circulation
