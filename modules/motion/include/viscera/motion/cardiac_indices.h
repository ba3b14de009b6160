#pragma once

#include <vector>

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

} // namespace viscera::motion
