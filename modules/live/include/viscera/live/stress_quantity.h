#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/elasticity/stated_material.h"

namespace viscera::live {

/// A quantity that a stress map can show, such as rotational stress or stretch.
enum class StressQuantity {
  rotationalStress, ///< Degrees: the largest angle between a direction and its image under the stretch.
  volumeRatio,      ///< det M.
  stretchMax,
  stretchMin,
  folded,   ///< 1 where det M <= 0, else 0.
  vonMises, ///< kPa, of a stated material.
  energy    ///< Strain energy per volume at rest, kPa (= mJ/ml), of a stated material.
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
  bool ofMaterial = false; ///< Exists of a stated material only.
};

/// All quantities, in the order of a list.
const std::vector<StressQuantityDescription>& stressQuantities();
const StressQuantityDescription& describe(StressQuantity quantity);
/// The quantity of that id, or the rotational stress.
StressQuantity stressQuantityFromId(const std::string& id);

/// A quantity with the material whose pascals it shows: one is needed for quantities of a material only, and
/// plays no part in the others.
struct StressMeasure {
  StressMeasure(StressQuantity which, elasticity::StatedMaterial of = {})
      : quantity(which), material(std::move(of)) {}

  /// Whether there are numbers of it: not of a material's quantity without a material.
  bool known() const { return !describe(quantity).ofMaterial || material.stated(); }
  /// Its unit with the material: "deg", empty, "kPa, liver (E 6.27 kPa)".
  Text unit() const;
  /// The same in fewer letters, for a number: "kPa, liver".
  Text shortUnit() const;

  bool operator==(const StressMeasure&) const = default;

  StressQuantity quantity;
  elasticity::StatedMaterial material;
};

/// The material in words: "liver (E 6.27 kPa)", "E 5 kPa"; empty where none is stated.
Text nameOf(const elasticity::StatedMaterial& material);

/// Volume ratios beyond these are no longer those of living tissue, which is mostly water.
inline constexpr double kLeastVolumeRatio = 0.8, kMostVolumeRatio = 1.25;

/// Says by how much the tissue is squeezed or swollen where a volume ratio of the first `count` points is
/// beyond those, in two sentences; empty where none is. Folded points do not count. O(count).
Text volumeRemark(const deformation::StressMap& map, Eigen::Index count);

/// Fills `values` (resized) with the quantity at every point of the map, in its unit; not a number where the
/// tissue is folded, except for the folded quantity itself, so that an angle never hides a fold; nowhere a
/// number for a quantity of a material without one. O(n).
void quantityOf(const deformation::StressMap& map, const StressMeasure& measure, Values& values);

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

/// The quantity at one point, folded or not; of a material not a number where it is folded.
double quantityAt(const deformation::StressMap& map, const StressMeasure& measure, Eigen::Index point);

} // namespace viscera::live
