#include "viscera/motion/measured_record.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tracked_volumes.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::motion {
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

double numberOf(const ordered_json& item, const char* name) {
  const double number = item.at(name).get<double>();
  if (!std::isfinite(number))
    throw DataError(phrase("%1 is not a finite number", name), "measured motion");
  return number;
}

tracking::SurfaceQuality surfaceFrom(const ordered_json& item) {
  tracking::SurfaceQuality surface;
  surface.measuredMl = numberOf(item, "measuredMl");
  surface.freeMl = numberOf(item, "freeMl");
  surface.fittedMl = numberOf(item, "fittedMl");
  surface.meanMm = numberOf(item, "meanMm");
  surface.p95Mm = numberOf(item, "p95Mm");
  surface.maxMm = numberOf(item, "maxMm");
  surface.flipped = item.at("flipped").get<int>();
  if (item.contains("dice"))
    surface.dice = numberOf(item, "dice");
  return surface;
}

TrackedPhase phaseFrom(const ordered_json& item, const MeasuredRecord& record) {
  TrackedPhase phase;
  tracking::PhaseQuality& quality = phase.quality;
  phase.seconds = numberOf(item, "seconds");
  for (const ordered_json& surface : item.at("surfaces")) {
    quality.surfaces.push_back(surfaceFrom(surface));
    if (const auto dice = quality.surfaces.back().dice)
      quality.dice = std::min(quality.dice.value_or(1), *dice);
  }
  if (quality.surfaces.size() != record.series.names.size())
    throw DataError("a phase lacks a surface", "measured motion");
  quality.meanMm = numberOf(item, "meanMm");
  quality.p95Mm = numberOf(item, "p95Mm");
  quality.maxMm = numberOf(item, "maxMm");
  quality.folded = item.at("folded").get<int>();
  quality.steps = item.at("steps").get<int>();
  quality.volumesMet = item.at("volumesMet").get<bool>();
  phase.verdict = tracking::verdictOf(quality, record.series.names, record.motion.sliceMm);
  return phase;
}

MeasuredRecord recordFrom(const ordered_json& root) {
  MeasuredRecord record;
  record.series.names = root.at("surfaces").get<std::vector<std::string>>();
  for (const ordered_json& id : root.at("organs"))
    record.organs.push_back({id.get<std::int64_t>()});
  record.motion.corresponding = root.at("corresponding").get<bool>();
  record.motion.sliceMm = numberOf(root, "sliceMm");
  for (const ordered_json& item : root.at("phases"))
    record.motion.phases.push_back(phaseFrom(item, record));
  if (record.organs.empty() || record.organs.size() != record.series.names.size() ||
      record.motion.phases.empty())
    throw DataError("it has no organ for each surface, or no phases", "measured motion");
  record.series.times = tracking::PhaseTimes::even(
      record.motion.phases.size(), numberOf(root, "periodSeconds"), root.at("loop").get<bool>());
  for (std::size_t phase = 0; phase < record.motion.phases.size(); ++phase) {
    record.series.times.seconds[phase] = record.motion.phases[phase].seconds;
    std::vector<double>& volumes = record.series.volumesMl.emplace_back();
    for (const tracking::SurfaceQuality& surface : record.motion.phases[phase].quality.surfaces)
      volumes.push_back(surface.measuredMl);
  }
  addVolumes(record.series, record.motion);
  return record;
}

} // namespace

std::string toJson(const MeasuredRecord& record) {
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
  return root.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

MeasuredRecord measuredRecordFrom(const std::string& text) {
  try {
    return recordFrom(ordered_json::parse(text));
  } catch (const ordered_json::exception&) {
    throw DataError("it is not a record of a measured motion", "measured motion");
  }
}

} // namespace viscera::motion
