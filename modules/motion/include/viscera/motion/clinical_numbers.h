#pragma once

#include <string>
#include <vector>

/// What a clinician reads off volumes, and what healthy people have.
namespace viscera::motion {

/// What a clinician reads off the volume curve of a ventricle.
struct CardiacIndices {
  double endDiastolicMl = 0;          ///< EDV: the largest volume of the cycle.
  double endSystolicMl = 0;           ///< ESV: the smallest.
  double strokeVolumeMl = 0;          ///< SV = EDV - ESV.
  double ejectionFraction = 0;        ///< EF = SV / EDV, 0 to 1.
  double cardiacOutputLPerMinute = 0; ///< CO = SV x rate.
};

/// Computes them from the volumes of at least one whole cycle. Throws `DataError` for no samples, volumes
/// that are not positive and finite, and `UsageError` for a rate that is not positive. O(samples).
CardiacIndices cardiacIndices(const std::vector<double>& volumesMl, double ratePerMinute);

/// What healthy people have, to be drawn behind a curve or written beside a number.
struct NormalRange {
  /// What is measured.
  enum class Quantity {
    endDiastolicMl,  ///< The largest volume of a ventricle over a beat.
    endSystolicMl,   ///< The smallest.
    ejectionPercent, ///< The part of the largest volume that leaves with a beat.
    volumeMl,        ///< A volume that the cycle leaves as it is.
  };
  Quantity quantity = Quantity::volumeMl;
  std::string name; ///< "end-diastolic volume"
  double low = 0;   ///< In ml or per cent, as the quantity says.
  double high = 0;
  std::string people; ///< Whose range it is: "108 healthy volunteers, mean +- one standard deviation".
  std::string source; ///< "Hudsmith and others 2005, doi ..."
};

/// The ranges known for an organ, by its name in a sample ("LV", "RV", "Stomach"; capitals do not matter);
/// empty for any other. A ventricle's range runs from the lower bound of women to the upper bound of men.
std::vector<NormalRange> normalRanges(const std::string& organ);

} // namespace viscera::motion
