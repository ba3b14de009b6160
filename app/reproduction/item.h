#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "reproduction/result.h"

namespace viscera::app::reproduction {

/// One figure or table that can be done again.
struct Item {
  std::string id;     ///< "3.14"
  bool table = false; ///< A table, not a figure.
  /// Fills everything but `id`, `table` and `seconds`. Throws `Cancelled`, and any other error where it
  /// cannot be measured.
  std::function<void(Result& result, const cli::Surroundings& surroundings, Progress& progress)> make;
};

/// The figures of chapter 3: attempts at cage-free coordinates, along lines.
std::vector<Item> chapter3();
/// Figures and tables of chapter 4: celestial coordinates.
std::vector<Item> chapter4();
/// Figures and tables of chapter 5: volume and stress.
std::vector<Item> chapter5();
/// All of them in the order of the thesis.
std::vector<Item> allItems();

} // namespace viscera::app::reproduction
