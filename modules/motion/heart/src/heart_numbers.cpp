#include "viscera/heart/heart_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"

namespace viscera::heart {
namespace {

constexpr double kMuscleGramsPerMl = 1.05;
constexpr double kMostellerDivisor = 3600; ///< cm kg / m4

void requireCurve(const std::vector<double>& fractions, const std::vector<double>& volumesMl) {
  if (volumesMl.empty() || fractions.size() != volumesMl.size())
    throw UsageError(misuse("A curve of volumes needs one fraction for each volume"));
}

/// Linear between the samples, and from the last to the first around the end of the cycle.
double volumeAt(double fraction, const std::vector<double>& fractions, const std::vector<double>& volumesMl) {
  const auto above = std::upper_bound(fractions.begin(), fractions.end(), fraction);
  const auto next = static_cast<std::size_t>(above - fractions.begin()) % fractions.size();
  const std::size_t last = (next + fractions.size() - 1) % fractions.size();
  double gap = fractions[next] - fractions[last], way = fraction - fractions[last];
  gap += gap <= 0 ? 1 : 0; // 0 for a cycle with both of its ends.
  way += way < 0 ? 1 : 0;
  const double part = gap > 0 ? std::clamp(way / gap, 0.0, 1.0) : 0;
  return volumesMl[last] + part * (volumesMl[next] - volumesMl[last]);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string all = "\"";
  for (const char letter : text)
    all += letter == '"' ? "\"\"" : std::string(1, letter);
  return all + "\"";
}

std::string written(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value);
  return digits;
}

} // namespace

CycleEnds cycleEnds(const std::vector<double>& fractions, const std::vector<double>& volumesMl,
                    const ChosenEnds& chosen) {
  requireCurve(fractions, volumesMl);
  const auto largest = std::max_element(volumesMl.begin(), volumesMl.end()) - volumesMl.begin();
  const auto smallest = std::min_element(volumesMl.begin(), volumesMl.end()) - volumesMl.begin();
  return {chosen.diastole.value_or(fractions[static_cast<std::size_t>(largest)]),
          chosen.systole.value_or(fractions[static_cast<std::size_t>(smallest)])};
}

CardiacIndices cardiacIndicesAt(const CycleEnds& ends, const std::vector<double>& fractions,
                                const std::vector<double>& volumesMl, double ratePerMinute) {
  requireCurve(fractions, volumesMl);
  cardiacIndices(volumesMl, ratePerMinute); // Refuses impossible volumes and rates.
  constexpr double kMlPerLiter = 1000;
  CardiacIndices indices;
  indices.endDiastolicMl = volumeAt(ends.diastole, fractions, volumesMl);
  indices.endSystolicMl = volumeAt(ends.systole, fractions, volumesMl);
  indices.strokeVolumeMl = indices.endDiastolicMl - indices.endSystolicMl;
  indices.ejectionFraction = indices.strokeVolumeMl / indices.endDiastolicMl;
  indices.cardiacOutputLPerMinute = indices.strokeVolumeMl * ratePerMinute / kMlPerLiter;
  return indices;
}

double bodySurfaceM2(double heightCm, double weightKg) {
  if (!(heightCm >= 30 && heightCm <= 250) || !(weightKg >= 1 && weightKg <= 400))
    throw UsageError("A body surface needs a height of 30 to 250 cm and a weight of 1 to 400 kg");
  return std::sqrt(heightCm * weightKg / kMostellerDivisor);
}

std::optional<double> muscleGrams(const std::vector<std::pair<std::string, double>>& organs) {
  for (const auto& [name, milliliters] : organs) {
    const auto part = anatomy::partNamed(name);
    if (part && part->organ == "myocardium" && part->side != anatomy::Side::right &&
        part->extent == anatomy::Extent::whole && milliliters > 0)
      return kMuscleGramsPerMl * milliliters;
  }
  return std::nullopt;
}

std::vector<HeartNumber> heartNumbers(const CardiacIndices& indices, std::optional<double> massG,
                                      double bodySurfaceM2) {
  constexpr double kHundred = 100;
  const auto indexed = [bodySurfaceM2](double value) {
    return bodySurfaceM2 > 0 ? std::optional(value / bodySurfaceM2) : std::nullopt;
  };
  std::vector<HeartNumber> numbers = {
      {"edv", "end-diastolic volume", "ml", indices.endDiastolicMl, indexed(indices.endDiastolicMl), 1},
      {"esv", "end-systolic volume", "ml", indices.endSystolicMl, indexed(indices.endSystolicMl), 1},
      {"sv", "stroke volume", "ml", indices.strokeVolumeMl, indexed(indices.strokeVolumeMl), 1},
      {"ef", "ejection fraction", "%", kHundred * indices.ejectionFraction, std::nullopt, 1},
      {"co", "cardiac output", "l/min", indices.cardiacOutputLPerMinute,
       indexed(indices.cardiacOutputLPerMinute), 2}};
  if (massG)
    numbers.push_back({"mass", "mass of the muscle", "g", *massG, indexed(*massG), 0});
  return numbers;
}

std::string heartNumbersCsv(const std::vector<std::pair<std::string, std::vector<HeartNumber>>>& ventricles) {
  std::string csv = "organ,number,value,unit,value_per_m2\n";
  for (const auto& [organ, numbers] : ventricles)
    for (const HeartNumber& number : numbers)
      csv += quoted(organ) + ',' + number.id + ',' + written(number.value) + ',' + number.unit + ',' +
             (number.perM2 ? written(*number.perM2) : "") + '\n';
  return csv;
}

} // namespace viscera::heart
