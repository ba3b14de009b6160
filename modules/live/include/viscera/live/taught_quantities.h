#pragma once

#include <string>
#include <vector>

#include "viscera/anatomy/norms.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

/// Compares the numbers that the program teaches with their normal ranges.
namespace viscera::live {

/// A number that the program shows in teaching, with its row in the table of normal ranges.
struct TaughtQuantity {
  const anatomy::Norm* norm = nullptr; ///< Never null.
  std::string where;                   ///< "heartbeat, 75 a minute"
  double here = 0;                     ///< In the norm's unit.
  std::string remark; ///< Remark on the comparison, or why the value is not within the range;
                      ///< may be empty.
};

/// Measures everything that sample organs, sequences and the circulation at rest teach, on the surfaces at
/// medium resolution where there are any: volumes at 192 instants of a beat. Some seconds once the organs are
/// in the library's cache. Throws what `setUpSequence` throws, and `Cancelled`.
std::vector<TaughtQuantity> taughtQuantities(const sample_organs::SampleLibrary& library, Progress& progress,
                                             Threads threads = {});

/// The quantities as a table in Markdown: what, where, here, in healthy adults, within or why not, whose,
/// source.
std::string markdownTable(const std::vector<TaughtQuantity>& quantities, const anatomy::Person& person = {});

/// "814 to 1906", "1200 and more", "up to 30".
std::string rangeText(const anatomy::Range& range);

} // namespace viscera::live
