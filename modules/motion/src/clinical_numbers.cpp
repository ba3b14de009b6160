#include "viscera/motion/clinical_numbers.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "viscera/core/error.h"

namespace viscera::motion {
namespace {

/// Mean and standard deviation.
struct Measured {
  double mean = 0;
  double deviation = 0;
};

constexpr const char* kOxford = "Hudsmith and others 2005 (Oxford), doi 10.1080/10976640500295516";
constexpr const char* kOxfordPeople = "108 healthy volunteers in magnetic resonance imaging, women's mean "
                                      "minus to men's mean plus one standard "
                                      "deviation";
constexpr const char* kFramingham = "Chuang and others 2014 (Framingham), doi 10.1002/jmri.24239";
constexpr const char* kFraminghamPeople =
    "685 healthy adults in magnetic resonance imaging, men's mean minus to "
    "women's mean plus one standard "
    "deviation";
// The middle is from one paper, the spread from another by the same group on largely the same people.
constexpr const char* kGastric =
    "middle: \"Simplifying the measurement of gastric accommodation using SPECT\"; "
    "spread: doi 10.1111/j.1365-2982.2010.01660.x";
constexpr const char* kGastricPeople =
    "median of 443 people after a meal, by single-photon tomography; minus to plus 16 %, by which 433 people "
    "differed from one another";

NormalRange between(NormalRange::Quantity quantity, const char* name, const Measured& women,
                    const Measured& men, const char* people, const char* source) {
  return {quantity,
          name,
          std::min(women.mean - women.deviation, men.mean - men.deviation),
          std::max(women.mean + women.deviation, men.mean + men.deviation),
          people,
          source};
}

using Quantity = NormalRange::Quantity;

std::vector<NormalRange> leftVentricle() {
  return {
      between(Quantity::endDiastolicMl, "end-diastolic volume", {135, 26}, {160, 29}, kOxfordPeople, kOxford),
      between(Quantity::endSystolicMl, "end-systolic volume", {42, 12}, {50, 16}, kOxfordPeople, kOxford),
      between(Quantity::ejectionPercent, "ejection fraction", {73, 6}, {71, 6}, kFraminghamPeople,
              kFramingham)};
}

std::vector<NormalRange> rightVentricle() {
  return {
      between(Quantity::endDiastolicMl, "end-diastolic volume", {148, 35}, {190, 33}, kOxfordPeople, kOxford),
      between(Quantity::endSystolicMl, "end-systolic volume", {56, 18}, {78, 20}, kOxfordPeople, kOxford)};
}

std::vector<NormalRange> stomach() {
  constexpr double kMiddle = 757, kVariation = 0.16;
  constexpr Measured kFed{kMiddle, kVariation * kMiddle};
  return {between(Quantity::volumeMl, "volume after a meal", kFed, kFed, kGastricPeople, kGastric)};
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

std::vector<NormalRange> normalRanges(const std::string& organ) {
  std::string name = organ;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (name == "lv" || name == "left ventricle")
    return leftVentricle();
  if (name == "rv" || name == "right ventricle")
    return rightVentricle();
  if (name == "stomach")
    return stomach();
  return {};
}

} // namespace viscera::motion
