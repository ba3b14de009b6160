#include "cli/strain_findings.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/listing.h"
#include "viscera/anatomy/norms.h"

namespace viscera::app::cli {
namespace {

using live::StrainDirection;
using live::StrainMoment;
using strain::ContourStrain;
using strain::SegmentStrain;

constexpr double kPercentOfPart = 100, kMsOfSecond = 1000;
constexpr std::pair<const char*, StrainDirection> kStrainDirections[] = {
    {"longitudinal", StrainDirection::longitudinal},
    {"circumferential", StrainDirection::circumferential},
    {"radial", StrainDirection::radial}};

std::string healthyRange(const char* id) {
  const anatomy::Norm& norm = anatomy::norm(id);
  const anatomy::Range range = anatomy::rangeOf(norm);
  return " (healthy adults " + fixed(range.low, 1) + " to " + fixed(range.high, 1) + ")";
}

/// " +- 1.2", or nothing where it is not known.
std::string uncertainty(const live::StrainReading& reading, int segment, StrainDirection direction) {
  const std::optional<double> deviation = live::strainDeviation(reading, segment, direction);
  return deviation ? " +- " + fixed(*deviation, 1) : std::string();
}

} // namespace

std::string strainText(const live::StrainReading& reading) {
  const strain::HeartStrain& strain = reading.strain;
  Listing listing;
  const auto percent = [](const ContourStrain& contour) {
    return fixed(kPercentOfPart * contour.peak.value, 1) + " % at " +
           fixed(kMsOfSecond * contour.peak.seconds, 0) + " ms";
  };
  const auto add = [&](const char* label, const std::optional<ContourStrain>& contour,
                       const std::string& range) {
    if (contour)
      listing.add(label, percent(*contour) + range);
  };
  listing.add("from phase", std::to_string(strain.reference + 1));
  add("GLS", strain.gls, healthyRange("lv.gls"));
  for (const ContourStrain& contour : strain.longitudinal)
    listing.add("  " + contour.name, percent(contour));
  add("GCS", strain.gcs, healthyRange("lv.gcs"));
  for (const ContourStrain& contour : strain.circumferential)
    listing.add("  " + contour.name, percent(contour));
  add("GRS", strain.grs, healthyRange("lv.grs"));
  add("RV free wall", strain.rightFreeWall, "");
  add("LA reservoir", strain.leftReservoir, "");
  for (const ContourStrain& area : strain.areas)
    listing.add("area of " + area.name, percent(area));
  const std::optional<double> twist = live::largestTurn(strain.twistDegrees),
                              torsion = live::largestTurn(strain.torsionDegreesPerCm);
  if (twist && torsion)
    listing.add("twist", fixed(*twist, 1) + " degrees, " + fixed(*torsion, 2) + " a cm");
  listing.add("dispersion", fixed(kMsOfSecond * strain.dispersionLongitudinal, 0) + " ms along, " +
                                fixed(kMsOfSecond * strain.dispersionCircumferential, 0) + " ms around");
  for (const strain::Segment& place : strain::segments()) {
    const SegmentStrain& segment = strain.segment(place.number);
    std::string text;
    for (const auto& [name, direction] : kStrainDirections)
      if (const auto value = live::strainValue(reading, place.number, direction, StrainMoment::peak))
        text += (text.empty() ? "" : ", ") + fixed(*value, 1) +
                uncertainty(reading, place.number, direction) + " % " + name;
    if (const auto wall = live::wallThickness(reading, place.number); wall && !text.empty())
      text +=
          ", " + fixed(wall->millimeters, 1) + " mm, thickens by " + fixed(wall->thickeningPercent, 0) + " %";
    text += text.empty() ? "too few points" : "";
    if (!reading.reliable(segment))
      text += "; not to be relied on";
    listing.add(std::to_string(place.number) + " " + std::string(place.name), text);
  }
  return listing.text();
}

} // namespace viscera::app::cli
