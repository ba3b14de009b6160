#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include <nlohmann/json.hpp>

#include "viscera/core/atomic_file.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/live/strain_reading.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;
using strain::ContourStrain;
using strain::SegmentStrain;

constexpr double kPercentOfPart = 100, kMsOfSecond = 1000;
constexpr std::pair<const char*, StrainDirection> kDirections[] = {
    {"longitudinal", StrainDirection::longitudinal},
    {"circumferential", StrainDirection::circumferential},
    {"radial", StrainDirection::radial}};

ordered_json placeJson(const Vec3& place) {
  return {place.x(), place.y(), place.z()};
}

ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json optionalJson(const std::optional<double>& value) {
  return value ? numberOrNull(*value) : ordered_json(nullptr);
}

ordered_json contourJson(const ContourStrain& contour) {
  ordered_json json = {{"peakPercent", numberOrNull(kPercentOfPart * contour.peak.value)},
                       {"timeMs", kMsOfSecond * contour.peak.seconds}};
  if (contour.referenceMm > 0)
    json["referenceMm"] = contour.referenceMm;
  return json;
}

ordered_json contourJson(const std::optional<ContourStrain>& contour) {
  return contour ? contourJson(*contour) : ordered_json(nullptr);
}

/// A mean with the contours that it is of.
ordered_json withParts(const std::optional<ContourStrain>& mean, const std::vector<ContourStrain>& parts) {
  ordered_json json = mean ? contourJson(*mean) : ordered_json::object();
  json.erase("referenceMm");
  for (const ContourStrain& part : parts)
    json[part.name] = contourJson(part);
  return json;
}

ordered_json segmentJson(const StrainReading& reading, const strain::Segment& place) {
  const SegmentStrain& segment = reading.strain.segment(place.number);
  ordered_json peak, time, deviation;
  for (const auto& [name, direction] : kDirections) {
    deviation[name] = optionalJson(strainDeviation(reading, place.number, direction));
    peak[name] = optionalJson(strainValue(reading, place.number, direction, StrainMoment::peak));
    time[name] = optionalJson(strainValue(reading, place.number, direction, StrainMoment::timeToPeak));
  }
  const auto area = std::min_element(segment.area.begin(), segment.area.end());
  peak["area"] = area == segment.area.end() ? ordered_json(nullptr) : numberOrNull(kPercentOfPart * *area);
  const std::optional<WallThickness> wall = wallThickness(reading, place.number);
  return {{"number", place.number},
          {"name", place.name},
          {"peak", std::move(peak)},
          {"deviationPercent", std::move(deviation)},
          {"timeToPeakMs", std::move(time)},
          {"thicknessMm", wall ? ordered_json(wall->millimeters) : ordered_json(nullptr)},
          {"thickeningPercent", wall ? ordered_json(wall->thickeningPercent) : ordered_json(nullptr)},
          {"witnesses", segment.witnesses},
          {"septal", place.septal},
          {"reliable", reading.reliable(segment)}};
}

ordered_json phaseJson(const strain::HeartStrain& strain, std::size_t phase) {
  ordered_json json = {{"timeMs", kMsOfSecond * strain.seconds[phase]}};
  const auto add = [&](const char* key, const std::optional<ContourStrain>& contour) {
    json[key] = contour ? numberOrNull(kPercentOfPart * contour->curve[phase]) : ordered_json(nullptr);
  };
  add("glsPercent", strain.gls);
  add("gcsPercent", strain.gcs);
  add("grsPercent", strain.grs);
  add("rvFreeWallPercent", strain.rightFreeWall);
  add("laReservoirPercent", strain.leftReservoir);
  for (const auto* contours : {&strain.longitudinal, &strain.circumferential, &strain.others})
    for (const ContourStrain& contour : *contours)
      json["contours"][contour.name] = numberOrNull(kPercentOfPart * contour.curve[phase]);
  for (const ContourStrain& area : strain.areas)
    json["areaPercent"][area.name] = numberOrNull(kPercentOfPart * area.curve[phase]);
  if (!strain.twistDegrees.empty())
    json["twistDegrees"] = strain.twistDegrees[phase];
  json["segments"] = ordered_json::array();
  for (const SegmentStrain& segment : strain.segments) {
    const auto at = [phase](const std::vector<double>& curve) {
      return curve.empty() ? ordered_json(nullptr) : numberOrNull(kPercentOfPart * curve[phase]);
    };
    json["segments"].push_back(
        {{"longitudinal", at(segment.longitudinal)},
         {"circumferential", at(segment.circumferential)},
         {"radial", at(segment.radial)},
         {"area", at(segment.area)},
         {"thicknessMm",
          segment.thicknessMm.empty() ? ordered_json(nullptr) : numberOrNull(segment.thicknessMm[phase])}});
  }
  return json;
}

ordered_json definitionJson(const StrainReading& reading) {
  return {
      {"length", "change of the length of a material contour of the endocardium against the reference phase"},
      {"material",
       reading.strain.wall
           ? "engineering strain sqrt(1 + 2 E) - 1 of Green and Lagrange at witness points of the wall"
           : "engineering strain of the endocardium's triangles: there is no wall"},
      {"gls", "length"},
      {"gcs", "length"},
      {"grs", "material"},
      {"segments", "material"},
      {"referencePhase", reading.strain.reference + 1},
      {"correspondence",
       reading.corresponding ? ordered_json(*reading.corresponding) : ordered_json(nullptr)}};
}

/// One column of the table.
struct StrainColumn {
  std::string name;
  std::vector<double> values;
  double factor = 1;
};

/// "rvFreeWall_percent" as "rv_free_wall_percent", as Python writes names.
std::string withUnderscores(const std::string& name) {
  std::string result;
  for (const char letter : name) {
    const bool capital = letter >= 'A' && letter <= 'Z';
    if (capital && !result.empty() && result.back() != '_')
      result += '_';
    result += capital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return result;
}

std::vector<StrainColumn> strainColumns(const strain::HeartStrain& strain) {
  std::vector<StrainColumn> columns = {{"time_s", strain.seconds}};
  const auto add = [&](const std::string& name, const std::optional<ContourStrain>& contour) {
    if (contour)
      columns.push_back({name + "_percent", contour->curve, kPercentOfPart});
  };
  add("gls", strain.gls);
  add("gcs", strain.gcs);
  add("grs", strain.grs);
  for (const auto* contours : {&strain.longitudinal, &strain.circumferential, &strain.others})
    for (const ContourStrain& contour : *contours)
      add(contour.name, contour);
  add("rvFreeWall", strain.rightFreeWall);
  add("laReservoir", strain.leftReservoir);
  for (const ContourStrain& area : strain.areas)
    add("area_" + area.name, area);
  if (!strain.twistDegrees.empty())
    columns.push_back({"twist_degrees", strain.twistDegrees});
  for (const SegmentStrain& segment : strain.segments) {
    const std::string name = "segment" + std::to_string(segment.number);
    columns.push_back({name + "_longitudinal_percent", segment.longitudinal, kPercentOfPart});
    columns.push_back({name + "_circumferential_percent", segment.circumferential, kPercentOfPart});
    if (!segment.radial.empty())
      columns.push_back({name + "_radial_percent", segment.radial, kPercentOfPart});
    if (!segment.thicknessMm.empty())
      columns.push_back({name + "_thickness_mm", segment.thicknessMm});
  }
  const std::size_t older = columns.size();
  for (std::size_t i = 0; i < older; ++i)
    if (std::string name = withUnderscores(columns[i].name); name != columns[i].name)
      columns.push_back({std::move(name), columns[i].values, columns[i].factor});
  return columns;
}

} // namespace

std::string strainJson(const StrainReading& reading) {
  const strain::HeartStrain& strain = reading.strain;
  ordered_json json;
  json["definition"] = definitionJson(reading);
  json["surfaces"] = {
      {"lv", reading.left}, {"rv", reading.right}, {"epi", reading.outer}, {"la", reading.atrium}};
  json["gls"] = withParts(strain.gls, strain.longitudinal);
  json["gcs"] = withParts(strain.gcs, strain.circumferential);
  json["grs"] = contourJson(strain.grs);
  json["material"] = {{"longitudinal", contourJson(strain.materialLongitudinal)},
                      {"circumferential", contourJson(strain.materialCircumferential)},
                      {"radial", contourJson(strain.grs)}};
  json["rvFreeWall"] = contourJson(strain.rightFreeWall);
  json["laReservoir"] = contourJson(strain.leftReservoir);
  json["contours"] = ordered_json::object();
  for (const ContourStrain& contour : strain.others)
    json["contours"][contour.name] = contourJson(contour);
  json["areaStrain"] = ordered_json::object();
  for (const ContourStrain& area : strain.areas)
    json["areaStrain"][area.name] = {{"peakPercent", kPercentOfPart * area.peak.value},
                                     {"timeMs", kMsOfSecond * area.peak.seconds},
                                     {"referenceMm2", area.referenceMm}};
  json["twistDegrees"] = optionalJson(largestTurn(strain.twistDegrees));
  json["torsionDegreesPerCm"] = optionalJson(largestTurn(strain.torsionDegreesPerCm));
  json["dispersionMs"] = {{"longitudinal", kMsOfSecond * strain.dispersionLongitudinal},
                          {"circumferential", kMsOfSecond * strain.dispersionCircumferential}};
  json["axes"] = {{"baseMm", placeJson(strain.axes.base())},
                  {"apexMm", placeJson(strain.axes.apex())},
                  {"towardsInsertion", placeJson(strain.axes.towardsInsertion())},
                  {"lengthMm", strain.axes.length()},
                  {"septumDegrees", strain.septumDegrees},
                  {"oriented", strain.oriented}};
  json["witnesses"] = reading.witnesses;
  json["segments"] = ordered_json::array();
  for (const strain::Segment& segment : strain::segments())
    json["segments"].push_back(segmentJson(reading, segment));
  json["phases"] = ordered_json::array();
  for (std::size_t phase = 0; phase < strain.seconds.size(); ++phase)
    json["phases"].push_back(phaseJson(strain, phase));
  json["warnings"] = inEnglish(reading.warnings);
  return json.dump();
}

void writeStrainTable(const std::filesystem::path& file, const StrainReading& reading) {
  const std::vector<StrainColumn> columns = strainColumns(reading.strain);
  std::string text;
  for (const StrainColumn& column : columns)
    text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (std::size_t phase = 0; phase < reading.strain.seconds.size(); ++phase) {
    std::string row;
    for (const StrainColumn& column : columns) {
      const double value = phase < column.values.size() ? column.factor * column.values[phase] : std::nan("");
      row += (&column == &columns.front() ? "" : ",") +
             (std::isfinite(value) ? significant(value, 9) : std::string());
    }
    text += row + '\n';
  }
  writeAtomically(file, [&text](std::ostream& stream) { stream << text; });
}

} // namespace viscera::live
