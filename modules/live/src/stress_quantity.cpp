#include "viscera/live/stress_quantity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "degrees.h"

namespace viscera::live {

const std::vector<StressQuantityDescription>& stressQuantities() {
  static const std::vector<StressQuantityDescription> all = {
      {StressQuantity::rotationalStress, "rotational-stress", "Rotational stress",
       "Maximum rotational stress",
       "The largest angle by which a direction is turned when the tissue is stretched; not a pressure.",
       "deg", false, 1},
      {StressQuantity::volumeRatio, "volume-ratio", "Volume ratio", "Extreme volume ratio",
       "The volume of tissue now, as a part of that at rest; 1 is unchanged.", "", true, 3},
      {StressQuantity::stretchMax, "largest-stretch", "Largest stretch", "Maximum of largest stretch",
       "The length of tissue now, as a part of that at rest, in the direction that grows most.", "", true, 3},
      {StressQuantity::stretchMin, "smallest-stretch", "Smallest stretch", "Minimum of smallest stretch",
       "The length of tissue now, as a part of that at rest, in the direction that shrinks most.", "", true,
       3},
      {StressQuantity::folded, "folded", "Folded tissue", "Tissue folded at any instant",
       "1 where the tissue is turned inside out.", "", false, 0},
      {StressQuantity::vonMises, "von-mises", "Von Mises stress", "Maximum von Mises stress",
       "The stress that shears the tissue, if it is the stated material; the change of its volume has no "
       "part "
       "in it.",
       "kPa", false, 3, true},
      {StressQuantity::energy, "strain-energy", "Strain energy density", "Maximum strain energy density",
       "The energy for each volume at rest, if the tissue is the stated material; with what the change of "
       "its "
       "volume takes.",
       "kPa", false, 3, true}};
  return all;
}

const StressQuantityDescription& describe(StressQuantity quantity) {
  return stressQuantities()[static_cast<std::size_t>(quantity)];
}

StressQuantity stressQuantityFromId(const std::string& id) {
  for (const StressQuantityDescription& description : stressQuantities())
    if (description.id == id)
      return description.quantity;
  return StressQuantity::rotationalStress;
}

Text nameOf(const elasticity::StatedMaterial& material) {
  if (!material.stated())
    return {};
  if (material.tissue.empty())
    return phrase("E %1 kPa", inDigits(material.youngKpa));
  return phrase("%1 (E %2 kPa)", named(material.tissue), inDigits(material.youngKpa));
}

Text StressMeasure::unit() const {
  const StressQuantityDescription& description = describe(quantity);
  if (description.unit.empty())
    return {};
  if (!description.ofMaterial || !material.stated())
    return named(description.unit);
  return listOf({named(description.unit), nameOf(material)});
}

Text StressMeasure::shortUnit() const {
  if (!describe(quantity).ofMaterial || material.tissue.empty())
    return unit();
  return listOf({named(describe(quantity).unit), named(material.tissue)});
}

double quantityAt(const deformation::StressMap& map, const StressMeasure& measure, Eigen::Index point) {
  const auto stretch = [&] {
    return elasticity::LocalStretch{map.stretchMax[point], map.stretchMin[point], map.volumeRatio[point]};
  };
  switch (measure.quantity) {
  case StressQuantity::rotationalStress:
    return kDegrees * map.rotationalStress[point];
  case StressQuantity::volumeRatio:
    return map.volumeRatio[point];
  case StressQuantity::stretchMax:
    return map.stretchMax[point];
  case StressQuantity::stretchMin:
    return map.stretchMin[point];
  case StressQuantity::vonMises:
    return map.extremes ? elasticity::shearKpa(measure.material) * map.extremes->vonMisesPerShear[point]
                        : elasticity::vonMisesKpa(measure.material, stretch());
  case StressQuantity::energy:
    if (!map.extremes)
      return elasticity::energyKpa(measure.material, stretch());
    return map.extremes->poisson == measure.material.poisson
               ? elasticity::shearKpa(measure.material) * map.extremes->energyPerShear[point]
               : std::numeric_limits<double>::quiet_NaN();
  case StressQuantity::folded:
    break;
  }
  return map.volumeRatio[point] <= 0 ? 1 : 0;
}

Text volumeRemark(const deformation::StressMap& map, Eigen::Index count) {
  double low = 1, high = 1;
  for (const double ratio : map.volumeRatio.head(count))
    if (ratio > 0 && std::isfinite(ratio)) {
      low = std::min(low, ratio);
      high = std::max(high, ratio);
    }
  const bool squeezed = low < kLeastVolumeRatio;
  const bool swollen = high > kMostVolumeRatio;
  const Text least = inFixed(100 * low, 0), most = inFixed(100 * high, 0);
  if (squeezed && swollen)
    return phrase(
        "Tissue is squeezed to %1 % of its volume in one place and swollen to %2 % in another. Living "
        "tissue, mostly water, hardly changes its volume; the coordinates do not know that. A smaller "
        "motion, more handles or a locked volume help.",
        least, most);
  if (squeezed)
    return phrase(
        "Tissue is squeezed to %1 % of its volume. Living tissue, mostly water, hardly changes its "
        "volume; the coordinates do not know that. A smaller motion, more handles or a locked volume "
        "help.",
        least);
  if (swollen)
    return phrase(
        "Tissue is swollen to %1 % of its volume. Living tissue, mostly water, hardly changes its "
        "volume; the coordinates do not know that. A smaller motion, more handles or a locked volume "
        "help.",
        most);
  return {};
}

void quantityOf(const deformation::StressMap& map, const StressMeasure& measure, Values& values) {
  values.resize(map.volumeRatio.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = map.volumeRatio[i] <= 0 && measure.quantity != StressQuantity::folded
                    ? std::numeric_limits<double>::quiet_NaN()
                    : quantityAt(map, measure, i);
}

QuantitySummary summaryOf(const Values& values, Eigen::Index count) {
  QuantitySummary summary;
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(count));
  for (Eigen::Index i = 0; i < count; ++i)
    if (std::isfinite(values[i]))
      numbers.push_back(values[i]);
  summary.missing = static_cast<int>(count - static_cast<Eigen::Index>(numbers.size()));
  if (numbers.empty())
    return summary;
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  summary.min = *low;
  summary.max = *high;
  summary.mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
  const auto ranked = [&numbers](double part) {
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(part * static_cast<double>(numbers.size()))) - 1;
    std::nth_element(numbers.begin(), numbers.begin() + rank, numbers.end());
    return numbers[static_cast<std::size_t>(rank)];
  };
  summary.percentile5 = ranked(0.05);
  summary.percentile95 = ranked(0.95);
  return summary;
}

} // namespace viscera::live
