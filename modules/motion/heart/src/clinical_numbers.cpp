#include "viscera/heart/clinical_numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::heart {
namespace {

using Quantity = NormalRange::Quantity;

/// A row of the table of normal ranges, and what it is drawn as.
struct Shown {
  std::string norm;
  Quantity quantity;
};

/// The volumes of a beat for a chamber, the volume for another organ.
std::vector<Shown> shownFor(const anatomy::Part& part) {
  if (part == anatomy::kLeftVentricle)
    return {{"lv.edv", Quantity::endDiastolicMl},
            {"lv.esv", Quantity::endSystolicMl},
            {"lv.ef", Quantity::ejectionPercent}};
  if (part == anatomy::kRightVentricle)
    return {{"rv.edv", Quantity::endDiastolicMl},
            {"rv.esv", Quantity::endSystolicMl},
            {"rv.ef", Quantity::ejectionPercent}};
  const anatomy::Norm* volume = anatomy::volumeNormOf(part);
  const anatomy::OrganFacts& facts = anatomy::organ(part.organ);
  const bool sideMissing = facts.volume != facts.volumeOfRight && part.side == anatomy::Side::none;
  if (!volume || volume->kind == anatomy::Kind::averages || sideMissing)
    return {};
  return {{volume->id, Quantity::volumeMl}};
}

} // namespace

CardiacIndices cardiacIndices(const std::vector<double>& volumesMl, double ratePerMinute) {
  constexpr double kMlPerLiter = 1000;
  if (!(ratePerMinute > 0) || !std::isfinite(ratePerMinute))
    throw UsageError(misuse("The heart rate has to be a positive number of beats a minute"));
  if (volumesMl.empty())
    throw DataError(misuse("There are no volumes to compute an ejection fraction from"), {},
                    misuse("play at least one whole beat"));
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

std::vector<NormalRange> normalRanges(const std::string& organ, const anatomy::Person& person) {
  std::vector<NormalRange> ranges;
  const std::optional<anatomy::Part> part = anatomy::partNamed(organ);
  for (const Shown& shown : part ? shownFor(*part) : std::vector<Shown>()) {
    const anatomy::Norm& norm = anatomy::norm(shown.norm);
    const anatomy::Range range = anatomy::rangeOf(norm, person);
    ranges.push_back({shown.quantity, norm.id, norm.quantity, range.low, range.high,
                      anatomy::meaningOf(norm, person), norm.people, norm.source});
  }
  return ranges;
}

} // namespace viscera::heart
