#include "viscera/motion/clinical_numbers.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "viscera/core/error.h"

namespace viscera::motion {
namespace {

using Quantity = NormalRange::Quantity;

/// A row of the table of normal ranges, and what it is drawn as.
struct Shown {
  const char* norm;
  Quantity quantity;
};

/// "Kidney, left" and "kidney_left" are "kidneyleft".
std::string lettersOf(const std::string& name) {
  std::string letters;
  for (const char c : name)
    if (std::isalpha(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

std::vector<Shown> shownFor(const std::string& organ) {
  static const std::vector<Shown> kLeft = {{"lv.edv", Quantity::endDiastolicMl},
                                           {"lv.esv", Quantity::endSystolicMl},
                                           {"lv.ef", Quantity::ejectionPercent}};
  static const std::vector<Shown> kRight = {{"rv.edv", Quantity::endDiastolicMl},
                                            {"rv.esv", Quantity::endSystolicMl},
                                            {"rv.ef", Quantity::ejectionPercent}};
  static const std::map<std::string, std::vector<Shown>> kOrgans = {
      {"lv", kLeft},
      {"lvcavity", kLeft},
      {"leftventricle", kLeft},
      {"rv", kRight},
      {"rvcavity", kRight},
      {"rightventricle", kRight},
      {"stomach", {{"stomach.volume", Quantity::volumeMl}}},
      {"liver", {{"liver.volume", Quantity::volumeMl}}},
      {"spleen", {{"spleen.volume", Quantity::volumeMl}}},
      {"pancreas", {{"pancreas.volume", Quantity::volumeMl}}},
      {"kidneyleft", {{"kidney.left", Quantity::volumeMl}}},
      {"leftkidney", {{"kidney.left", Quantity::volumeMl}}},
      {"kidneyright", {{"kidney.right", Quantity::volumeMl}}},
      {"rightkidney", {{"kidney.right", Quantity::volumeMl}}}};
  const auto found = kOrgans.find(lettersOf(organ));
  return found == kOrgans.end() ? std::vector<Shown>() : found->second;
}

} // namespace

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

std::vector<NormalRange> normalRanges(const std::string& organ, const anatomy::Person& person) {
  std::vector<NormalRange> ranges;
  for (const Shown& shown : shownFor(organ)) {
    const anatomy::Norm& norm = anatomy::norm(shown.norm);
    const anatomy::Range range = anatomy::rangeOf(norm, person);
    ranges.push_back({shown.quantity, norm.id, norm.quantity, range.low, range.high,
                      anatomy::meaningOf(norm, person), norm.people, norm.source});
  }
  return ranges;
}

std::optional<Chamber> heartChamber(const std::string& organ) {
  std::set<std::string> words;
  std::string word;
  for (const char c : organ + ' ') {
    if (std::isalpha(static_cast<unsigned char>(c))) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  const auto has = [&](const char* one) { return words.count(one) > 0; };
  for (const char* wall : {"wall", "muscle", "myocardium", "myo", "epi", "epicardium", "epicardial"})
    if (has(wall))
      return std::nullopt;
  const bool ventricle = has("ventricle") || has("ventricular"), atrium = has("atrium") || has("atrial");
  if (has("lv") || (ventricle && has("left")))
    return Chamber::leftVentricle;
  if (has("rv") || (ventricle && has("right")))
    return Chamber::rightVentricle;
  if (has("la") || (atrium && has("left")))
    return Chamber::leftAtrium;
  if (has("ra") || (atrium && has("right")))
    return Chamber::rightAtrium;
  return std::nullopt;
}

} // namespace viscera::motion
