#include "viscera/live/measured_record.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "cine_json.h"
#include "tracked_volumes.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;

ordered_json surfaceJson(const tracking::SurfaceQuality& surface) {
  ordered_json item{{"measuredMl", surface.measuredMl}, {"freeMl", surface.freeMl},
                    {"fittedMl", surface.fittedMl},     {"meanMm", surface.meanMm},
                    {"p95Mm", surface.p95Mm},           {"maxMm", surface.maxMm},
                    {"flipped", surface.flipped}};
  if (surface.dice)
    item["dice"] = *surface.dice;
  return item;
}

tracking::SurfaceQuality surfaceFrom(const JsonReader& reader, const ordered_json& item,
                                     const std::string& place) {
  tracking::SurfaceQuality surface;
  surface.measuredMl = reader.valueOf<double>(item, "measuredMl", place);
  surface.freeMl = reader.valueOf<double>(item, "freeMl", place);
  surface.fittedMl = reader.valueOf<double>(item, "fittedMl", place);
  surface.meanMm = reader.valueOf<double>(item, "meanMm", place);
  surface.p95Mm = reader.valueOf<double>(item, "p95Mm", place);
  surface.maxMm = reader.valueOf<double>(item, "maxMm", place);
  surface.flipped = reader.valueOf<int>(item, "flipped", place);
  if (item.contains("dice"))
    surface.dice = reader.valueOf<double>(item, "dice", place);
  return surface;
}

TrackedPhase phaseFrom(const JsonReader& reader, const ordered_json& item, const std::string& place,
                       const MeasuredRecord& record) {
  TrackedPhase phase;
  tracking::PhaseQuality& quality = phase.quality;
  phase.seconds = reader.valueOf<double>(item, "seconds", place);
  reader.eachOf(item, "surfaces", place, [&](const ordered_json& surface, const std::string& inPhase) {
    quality.surfaces.push_back(surfaceFrom(reader, surface, inPhase));
    if (const auto dice = quality.surfaces.back().dice)
      quality.dice = std::min(quality.dice.value_or(1), *dice);
  });
  if (quality.surfaces.size() != record.series.names.size())
    throw DataError(diagnostic("a phase lacks a surface"), diagnostic("measured motion"));
  quality.meanMm = reader.valueOf<double>(item, "meanMm", place);
  quality.p95Mm = reader.valueOf<double>(item, "p95Mm", place);
  quality.maxMm = reader.valueOf<double>(item, "maxMm", place);
  quality.folded = reader.valueOf<int>(item, "folded", place);
  quality.steps = reader.valueOf<int>(item, "steps", place);
  quality.volumesMet = reader.valueOf<bool>(item, "volumesMet", place);
  phase.verdict = tracking::verdictOf(quality, record.series.names, record.motion.sliceMm);
  return phase;
}

/// Verdicts that images had a part in, and no number where a label alone would tell it.
void readImages(const JsonReader& reader, const ordered_json& item, MeasuredRecord& record) {
  auto images = std::make_shared<CineRecord>(cineRecordFrom(reader, item, "images"));
  const std::vector<tracking::FitVerdict> verdicts = verdictsFrom(reader, item, "images");
  const std::size_t phases = record.motion.phases.size();
  const bool fits =
      verdicts.size() == phases &&
      std::all_of(images->found.planes.begin(), images->found.planes.end(),
                  [phases](const CinePlaneUse& plane) { return plane.states.size() == phases; }) &&
      std::all_of(images->found.labelled.begin(), images->found.labelled.end(),
                  [phases](std::size_t phase) { return phase < phases; });
  if (!fits)
    throw DataError(diagnostic("its planes and verdicts are not those of its phases"),
                    diagnostic("measured motion"));
  for (std::size_t phase = 0; phase < phases; ++phase)
    record.motion.phases[phase].verdict = verdicts[phase];
  dropUncertain(images->found.estimate, record.motion);
  record.images = std::move(images);
}

MeasuredRecord recordFrom(const JsonReader& reader, const ordered_json& root) {
  MeasuredRecord record;
  record.series.names = reader.valueOf<std::vector<std::string>>(root, "surfaces", "");
  for (const std::int64_t id : reader.valueOf<std::vector<std::int64_t>>(root, "organs", ""))
    record.organs.push_back({id});
  record.motion.corresponding = reader.valueOf<bool>(root, "corresponding", "");
  record.motion.sliceMm = reader.valueOf<double>(root, "sliceMm", "");
  reader.eachOf(root, "phases", "", [&](const ordered_json& item, const std::string& place) {
    record.motion.phases.push_back(phaseFrom(reader, item, place, record));
  });
  if (record.organs.empty() || record.organs.size() != record.series.names.size() ||
      record.motion.phases.empty())
    throw DataError(diagnostic("it has no organ for each surface, or no phases"),
                    diagnostic("measured motion"));
  record.series.times = tracking::PhaseTimes::even(record.motion.phases.size(),
                                                   reader.valueOf<double>(root, "periodSeconds", ""),
                                                   reader.valueOf<bool>(root, "loop", ""));
  for (std::size_t phase = 0; phase < record.motion.phases.size(); ++phase) {
    record.series.times.seconds[phase] = record.motion.phases[phase].seconds;
    std::vector<double>& volumes = record.series.volumesMl.emplace_back();
    for (const tracking::SurfaceQuality& surface : record.motion.phases[phase].quality.surfaces)
      volumes.push_back(surface.measuredMl);
  }
  addVolumes(record.series, record.motion);
  if (root.contains("images"))
    readImages(reader, root.at("images"), record);
  return record;
}

} // namespace

ordered_json toJson(const MeasuredRecord& record) {
  ordered_json root{{"surfaces", record.series.names},
                    {"organs", ordered_json::array()},
                    {"periodSeconds", record.series.times.periodSeconds},
                    {"loop", record.series.times.loop},
                    {"corresponding", record.motion.corresponding},
                    {"sliceMm", record.motion.sliceMm},
                    {"phases", ordered_json::array()}};
  for (const document::OrganId organ : record.organs)
    root["organs"].push_back(organ.value);
  for (const TrackedPhase& phase : record.motion.phases) {
    const tracking::PhaseQuality& quality = phase.quality;
    ordered_json item{{"seconds", phase.seconds},        {"meanMm", quality.meanMm}, {"p95Mm", quality.p95Mm},
                      {"maxMm", quality.maxMm},          {"folded", quality.folded}, {"steps", quality.steps},
                      {"volumesMet", quality.volumesMet}};
    item["surfaces"] = ordered_json::array();
    for (const tracking::SurfaceQuality& surface : quality.surfaces)
      item["surfaces"].push_back(surfaceJson(surface));
    root["phases"].push_back(std::move(item));
  }
  if (record.images)
    root["images"] = cineRecordJson(*record.images, record.motion);
  return root;
}

MeasuredRecord measuredRecordFrom(const ordered_json& item) {
  const JsonReader reader(diagnostic("measured motion").english(), Text());
  try {
    return recordFrom(reader, item);
  } catch (const JsonError& error) {
    throw DataError(diagnostic("it is not a record of a measured motion"), error.where());
  }
}

} // namespace viscera::live
