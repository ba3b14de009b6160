#pragma once

#include <functional>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/thesis/result.h"

/// Reproduces figures and tables of the thesis that the program is based on.
namespace viscera::thesis {

/// The coordinate systems and sample organs with which figures are measured. Outlived by both references.
struct Bench {
  const coordinates::Registry& systems;
  const sample_organs::SampleLibrary& samples;
  Threads threads = {};
};

/// One figure or table of the thesis that can be reproduced.
struct Item {
  std::string id;     ///< "3.14"
  bool table = false; ///< A table, not a figure.
  /// Fills everything but `id`, `table` and `seconds`. Throws `Cancelled`, and any other error where it
  /// cannot be measured.
  std::function<void(Result& result, const Bench& bench, Progress& progress)> make;

  /// "3.14"; table 4.1 is "table-4.1", so that it is not taken for figure 4.1.
  std::string name() const { return (table ? "table-" : "") + id; }
};

/// Finds the items with the given names; without names all, in the order of the thesis. Throws `UsageError`
/// for a name that there is not.
std::vector<Item> chosenItems(const std::vector<std::string>& names);

/// Reproduces all items, one after the other; milliseconds to half a minute each. The error of an item is
/// stored in its `Result::problem`, and the other items are still reproduced. Throws `Cancelled`.
///
///     const coordinates::Registry systems = coordinates::builtInRegistry();
///     const sample_organs::SampleLibrary samples = sample_organs::standardLibrary();
///     const auto results = makeAll(chosenItems({"3.14"}), {systems, samples}, progress);
std::vector<Result> makeAll(const std::vector<Item>& items, const Bench& bench, Progress& progress);

} // namespace viscera::thesis
