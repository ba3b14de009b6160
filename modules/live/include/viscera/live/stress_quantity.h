#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::live {

/// A quantity that a stress map can show, such as rotational stress or stretch.
enum class StressQuantity {
  rotationalStress, ///< Degrees: the largest angle between a direction and its image under the stretch.
  volumeRatio,      ///< det M.
  stretchMax,
  stretchMin,
  folded ///< 1 where det M <= 0, else 0.
};

/// Name, unit and number of decimals of a quantity, for users.
struct StressQuantityDescription {
  StressQuantity quantity = StressQuantity::rotationalStress;
  std::string id;       ///< "rotational-stress"; as in settings.
  std::string name;     ///< "Rotational stress"
  std::string peakName; ///< "Maximum rotational stress": whole, for languages that have cases and capitals.
  std::string meaning;  ///< What a number of it says, a sentence.
  std::string unit;     ///< "deg" or empty.
  bool ratio = false;   ///< 1 means unchanged.
  int decimals = 2;
};

/// All quantities, in the order of a list.
const std::vector<StressQuantityDescription>& stressQuantities();
const StressQuantityDescription& describe(StressQuantity quantity);
/// The quantity of that id, or the rotational stress.
StressQuantity stressQuantityFromId(const std::string& id);

/// Volume ratios beyond these are no longer those of living tissue, which is mostly water.
inline constexpr double kLeastVolumeRatio = 0.8, kMostVolumeRatio = 1.25;

/// Says by how much the tissue is squeezed or swollen where a volume ratio of the first `count` points is
/// beyond those, in two sentences; empty where none is. Folded points do not count. O(count).
Text volumeRemark(const deformation::StressMap& map, Eigen::Index count);

/// Fills `values` (resized) with the quantity at every point of the map, in its unit; not a number where the
/// tissue is folded, except for the folded quantity itself, so that an angle never hides a fold. O(n).
void quantityOf(const deformation::StressMap& map, StressQuantity quantity, Values& values);

/// Summary statistics of a quantity; values that are not numbers are counted apart.
struct QuantitySummary {
  double min = 0;
  double percentile5 = 0;
  double mean = 0;
  double percentile95 = 0;
  double max = 0;
  int missing = 0;
};
/// Summarises the first `count` values; zeros when there is no number among them. O(count).
QuantitySummary summaryOf(const Values& values, Eigen::Index count);

/// The quantity at one point, folded or not.
double quantityAt(const deformation::StressMap& map, StressQuantity quantity, Eigen::Index point);

} // namespace viscera::live
