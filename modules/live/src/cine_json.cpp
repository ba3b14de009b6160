#include "cine_json.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/document/stored_text.h"
#include "viscera/live/contour_corrections.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;
using tracking::FitLight;

constexpr std::array<const char*, 3> kLightIds = {"good", "amber", "red"};
constexpr std::array<const char*, 6> kStateIds = {"used",   "leavesPlane", "unlike",
                                                  "noWall", "noImage",     "labelled"};
constexpr std::array<const char*, 6> kViewIds = {"shortAxis",   "twoChamber", "threeChamber",
                                                 "fourChamber", "longAxis",   "other"};

/// The value of an enumeration by its name in a file.
template <class Value, std::size_t count>
Value valueFrom(const std::array<const char*, count>& ids, const JsonReader& reader, const ordered_json& item,
                const char* key, const std::string& place) {
  const std::string id = reader.textOf(item, key, place);
  for (std::size_t i = 0; i < count; ++i)
    if (id == ids[i])
      return static_cast<Value>(i);
  reader.fail(diagnostic("there is no %1 \"%2\"", key, id), place);
}

std::size_t indexFrom(const JsonReader& reader, const ordered_json& item, const char* key,
                      const std::string& place) {
  return static_cast<std::size_t>(
      reader.wholeOf(reader.field(item, key, place), JsonReader::inside(place, key)));
}

std::vector<Text> wordsFrom(const JsonReader& reader, const ordered_json& item, const char* key,
                            const std::string& place) {
  JsonReader own = reader; // It remembers keys that it does not know.
  return document::textsFrom(own, reader.field(item, key, place), JsonReader::inside(place, key));
}

Text firstOf(const std::vector<Text>& texts) {
  return texts.empty() ? Text() : texts.front();
}

ordered_json requestJson(const CineRequest& request) {
  ordered_json item{{"images", request.images.string()}, {"labels", ordered_json::array()}};
  for (const PhaseLabels& labels : request.labels) {
    ordered_json files = ordered_json::array();
    for (const std::filesystem::path& file : labels.files)
      files.push_back(file.string());
    item["labels"].push_back({{"phase", labels.phase}, {"files", std::move(files)}});
  }
  item["surfaces"] = ordered_json::array();
  for (const LabelledSurface& surface : request.surfaces)
    item["surfaces"].push_back({{"name", surface.name}, {"labels", surface.labels}});
  if (request.periodSeconds)
    item["periodSeconds"] = *request.periodSeconds;
  item["leftOutSeries"] = request.leftOutSeries;
  item["firstPhase"] = request.firstPhase;
  if (!request.corrections.empty())
    item["corrections"] = toJson(request.corrections);
  return item;
}

CineRequest requestFrom(const JsonReader& reader, const ordered_json& item, const std::string& place) {
  CineRequest request;
  request.images = reader.valueOf<std::string>(item, "images", place);
  reader.eachOf(item, "labels", place, [&](const ordered_json& labels, const std::string& at) {
    PhaseLabels& phase = request.labels.emplace_back();
    phase.phase = indexFrom(reader, labels, "phase", at);
    for (const std::string& file : reader.valueOf<std::vector<std::string>>(labels, "files", at))
      phase.files.emplace_back(file);
  });
  reader.eachOf(item, "surfaces", place, [&](const ordered_json& surface, const std::string& at) {
    request.surfaces.push_back({reader.valueOf<std::string>(surface, "name", at),
                                reader.valueOf<std::vector<std::string>>(surface, "labels", at)});
  });
  if (item.contains("periodSeconds"))
    request.periodSeconds = reader.valueOf<double>(item, "periodSeconds", place);
  request.leftOutSeries = reader.valueOf<std::vector<int>>(item, "leftOutSeries", place);
  request.firstPhase = indexFrom(reader, item, "firstPhase", place);
  request.corrections = correctionsFrom(reader, item, place);
  return request;
}

ordered_json planeJson(const CinePlaneUse& plane) {
  ordered_json phases = ordered_json::array();
  for (std::size_t phase = 0; phase < plane.shares.size(); ++phase) {
    const tracking::PlaneShare& share = plane.shares[phase];
    phases.push_back({{"state", kStateIds[static_cast<std::size_t>(plane.states[phase])]},
                      {"weight", share.weight},
                      {"likeness", share.likeness},
                      {"closureMm", share.closureMm},
                      {"apartMm", share.apartMm},
                      {"points", share.points}});
  }
  return {{"slice", plane.source.slice},
          {"series", plane.source.series},
          {"name", document::storedTexts({plane.source.name})},
          {"view", kViewIds[static_cast<std::size_t>(plane.source.view)]},
          {"longAxis", plane.longAxis},
          {"weight", plane.weight},
          {"likeness", plane.likeness},
          {"closureMm", plane.closureMm},
          {"apartMm", plane.apartMm},
          {"light", kLightIds[static_cast<std::size_t>(plane.light)]},
          {"reason", document::storedTexts({plane.reason})},
          {"phases", std::move(phases)}};
}

CinePlaneUse planeFrom(const JsonReader& reader, const ordered_json& item, const std::string& place) {
  CinePlaneUse plane;
  plane.source.slice = indexFrom(reader, item, "slice", place);
  plane.source.series = reader.valueOf<int>(item, "series", place);
  plane.source.name = firstOf(wordsFrom(reader, item, "name", place));
  plane.source.view = valueFrom<medical_io::CinePlane>(kViewIds, reader, item, "view", place);
  plane.longAxis = reader.valueOf<bool>(item, "longAxis", place);
  plane.weight = reader.valueOf<double>(item, "weight", place);
  plane.likeness = reader.valueOf<double>(item, "likeness", place);
  plane.closureMm = reader.valueOf<double>(item, "closureMm", place);
  plane.apartMm = reader.valueOf<double>(item, "apartMm", place);
  plane.light = valueFrom<FitLight>(kLightIds, reader, item, "light", place);
  plane.reason = firstOf(wordsFrom(reader, item, "reason", place));
  reader.eachOf(item, "phases", place, [&](const ordered_json& phase, const std::string& at) {
    plane.states.push_back(valueFrom<PlaneState>(kStateIds, reader, phase, "state", at));
    plane.shares.push_back(
        {reader.valueOf<double>(phase, "weight", at), reader.valueOf<double>(phase, "likeness", at),
         reader.valueOf<double>(phase, "closureMm", at), reader.valueOf<double>(phase, "apartMm", at),
         reader.valueOf<int>(phase, "points", at)});
  });
  return plane;
}

ordered_json findingJson(const CineFinding& finding) {
  ordered_json item{{"light", kLightIds[static_cast<std::size_t>(finding.light)]},
                    {"text", document::storedTexts({finding.text})}};
  if (finding.phase)
    item["phase"] = *finding.phase;
  if (finding.plane)
    item["plane"] = *finding.plane;
  return item;
}

CineFinding findingFrom(const JsonReader& reader, const ordered_json& item, const std::string& place) {
  CineFinding finding{valueFrom<FitLight>(kLightIds, reader, item, "light", place),
                      firstOf(wordsFrom(reader, item, "text", place))};
  if (item.contains("phase"))
    finding.phase = indexFrom(reader, item, "phase", place);
  if (item.contains("plane"))
    finding.plane = indexFrom(reader, item, "plane", place);
  return finding;
}

} // namespace

ordered_json cineRecordJson(const CineRecord& record, const PatientMotion& motion) {
  const CineMotion& found = record.found;
  ordered_json item{{"request", requestJson(record.request)},
                    {"study", record.study},
                    {"handles", record.handles},
                    {"keepVolumes", record.keepVolumes},
                    {"labelled", found.labelled},
                    {"estimate", found.estimate},
                    {"endDiastole", found.endDiastole},
                    {"endSystole", found.endSystole},
                    {"fullest", found.fullest},
                    {"emptiest", found.emptiest}};
  for (const char* key : {"planes", "findings", "verdicts"})
    item[key] = ordered_json::array();
  for (const CinePlaneUse& plane : found.planes)
    item["planes"].push_back(planeJson(plane));
  for (const CineFinding& finding : found.findings)
    item["findings"].push_back(findingJson(finding));
  for (const TrackedPhase& phase : motion.phases)
    item["verdicts"].push_back({{"light", kLightIds[static_cast<std::size_t>(phase.verdict.light)]},
                                {"reasons", document::storedTexts(phase.verdict.reasons)}});
  return item;
}

CineRecord cineRecordFrom(const JsonReader& reader, const ordered_json& item, const std::string& place) {
  CineRecord record;
  record.request =
      requestFrom(reader, reader.field(item, "request", place), JsonReader::inside(place, "request"));
  record.study = reader.valueOf<std::string>(item, "study", place);
  record.handles = reader.valueOf<int>(item, "handles", place);
  record.keepVolumes = reader.valueOf<bool>(item, "keepVolumes", place);
  CineMotion& found = record.found;
  for (const std::int64_t phase : reader.valueOf<std::vector<std::int64_t>>(item, "labelled", place))
    found.labelled.push_back(static_cast<std::size_t>(phase));
  found.estimate = reader.valueOf<bool>(item, "estimate", place);
  found.endDiastole = indexFrom(reader, item, "endDiastole", place);
  found.endSystole = indexFrom(reader, item, "endSystole", place);
  found.fullest = indexFrom(reader, item, "fullest", place);
  found.emptiest = indexFrom(reader, item, "emptiest", place);
  reader.eachOf(item, "planes", place, [&](const ordered_json& plane, const std::string& at) {
    found.planes.push_back(planeFrom(reader, plane, at));
  });
  reader.eachOf(item, "findings", place, [&](const ordered_json& finding, const std::string& at) {
    found.findings.push_back(findingFrom(reader, finding, at));
  });
  return record;
}

std::vector<tracking::FitVerdict> verdictsFrom(const JsonReader& reader, const ordered_json& item,
                                               const std::string& place) {
  std::vector<tracking::FitVerdict> verdicts;
  reader.eachOf(item, "verdicts", place, [&](const ordered_json& verdict, const std::string& at) {
    verdicts.push_back({valueFrom<FitLight>(kLightIds, reader, verdict, "light", at),
                        wordsFrom(reader, verdict, "reasons", at)});
  });
  return verdicts;
}

} // namespace viscera::live
