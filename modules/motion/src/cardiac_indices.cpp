#include "viscera/motion/cardiac_indices.h"

#include <algorithm>
#include <cmath>

#include "viscera/core/error.h"

namespace viscera::motion {

CardiacIndices cardiacIndices(const std::vector<double>& volumesMl, double ratePerMinute) {
  constexpr double kMlPerLiter = 1000;
  if (!(ratePerMinute > 0) || !std::isfinite(ratePerMinute))
    throw UsageError("The heart rate has to be a positive number of beats a minute");
  if (volumesMl.empty())
    throw DataError("There are no volumes to compute an ejection fraction from", {},
                    "play at least one whole beat");
  for (const double volume : volumesMl)
    if (!(volume > 0) || !std::isfinite(volume))
      throw DataError("A ventricle's volume is not positive", {},
                      "check that its surface is closed and outward");
  const auto [smallest, largest] = std::minmax_element(volumesMl.begin(), volumesMl.end());
  CardiacIndices indices;
  indices.endDiastolicMl = *largest;
  indices.endSystolicMl = *smallest;
  indices.strokeVolumeMl = *largest - *smallest;
  indices.ejectionFraction = indices.strokeVolumeMl / *largest;
  indices.cardiacOutputLPerMinute = indices.strokeVolumeMl * ratePerMinute / kMlPerLiter;
  return indices;
}

} // namespace viscera::motion
