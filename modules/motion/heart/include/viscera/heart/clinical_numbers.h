#pragma once

#include <string>
#include <vector>

#include "viscera/anatomy/norms.h"
#include "viscera/core/phrase.h"

/// Clinical numbers computed from volumes, such as ejection fraction, and their normal ranges.
namespace viscera::heart {

/// End-diastolic and end-systolic volume, stroke volume, ejection fraction and output of a ventricle.
struct CardiacIndices {
  double endDiastolicMl = 0;          ///< EDV: the largest volume of the cycle.
  double endSystolicMl = 0;           ///< ESV: the smallest.
  double strokeVolumeMl = 0;          ///< SV = EDV - ESV.
  double ejectionFraction = 0;        ///< EF = SV / EDV, 0 to 1.
  double cardiacOutputLPerMinute = 0; ///< CO = SV x rate.
};

/// Computes these numbers from the volumes of at least one whole cycle. Throws `DataError` for no samples,
/// volumes that are not positive and finite, and `UsageError` for a rate that is not positive. O(samples).
CardiacIndices cardiacIndices(const std::vector<double>& volumesMl, double ratePerMinute);

/// A normal range with its name and source, to be drawn behind a curve or written beside a number.
struct NormalRange {
  /// The measured quantity.
  enum class Quantity {
    endDiastolicMl,  ///< The largest volume of a ventricle over a beat.
    endSystolicMl,   ///< The smallest.
    ejectionPercent, ///< The part of the largest volume that leaves with a beat.
    volumeMl,        ///< A volume that is constant over the cycle.
  };
  Quantity quantity = Quantity::volumeMl;
  std::string norm; ///< Its row in the table of `anatomy`: "lv.edv".
  std::string name; ///< "end-diastolic volume"
  double low = 0;   ///< In ml or per cent, as the quantity says.
  double high = 0;
  Text meaning;       ///< How the range is defined: "women, mean +- 2 standard deviations".
  std::string people; ///< The people that were measured: "800 healthy people of 45 to 74 years, ...".
  std::string source; ///< "Petersen 2017, doi ..."
};

/// The ranges known for the organ that a name means (`anatomy::partNamed`), for that person; empty for any
/// other, and for a kidney without a side. The heart has none: its surface takes in stumps of the great
/// vessels, and no spread of the whole organ is known.
std::vector<NormalRange> normalRanges(const std::string& organ, const anatomy::Person& person = {});

} // namespace viscera::heart
