#include "cli/cine_track.h"

#include <algorithm>
#include <charconv>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/live/contour_corrections.h"

namespace viscera::app::cli {
namespace {

using live::CineMotion;
using live::CinePlaneUse;
using live::PlaneState;
using nlohmann::ordered_json;

const char* lightName(tracking::FitLight light) {
  return light == tracking::FitLight::good ? "good" : light == tracking::FitLight::amber ? "amber" : "red";
}

const char* stateName(PlaneState state) {
  switch (state) {
  case PlaneState::used:
    return "used";
  case PlaneState::leavesPlane:
    return "leaves plane";
  case PlaneState::unlike:
    return "unlike";
  case PlaneState::noWall:
    return "no wall";
  case PlaneState::noImage:
    return "no image";
  case PlaneState::labelled:
    return "labelled";
  }
  return "";
}

/// "9=es.nrrd" added to the labels.
void addLabels(const std::string& text, std::vector<live::PhaseLabels>& labels) {
  const std::size_t equal = text.find('=');
  std::size_t phase = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + std::min(equal, text.size()), phase);
  if (equal == std::string::npos || error != std::errc() || end != text.data() + equal ||
      equal + 1 == text.size())
    throw UsageError("It is not a phase and its file", "--phase " + text,
                     "as in --phase 9=es.nrrd; the first phase is 0");
  const auto known = std::find_if(labels.begin(), labels.end(),
                                  [&](const live::PhaseLabels& each) { return each.phase == phase; });
  (known == labels.end() ? labels.emplace_back(live::PhaseLabels{phase, {}}) : *known)
      .files.emplace_back(text.substr(equal + 1));
}

ordered_json planeJson(const CinePlaneUse& use) {
  ordered_json phases = ordered_json::array();
  for (std::size_t phase = 0; phase < use.shares.size(); ++phase) {
    const tracking::PlaneShare& share = use.shares[phase];
    phases.push_back({{"state", stateName(use.states[phase])},
                      {"weight", share.weight},
                      {"likeness", share.likeness},
                      {"closureMm", share.closureMm},
                      {"apartMm", share.apartMm},
                      {"points", share.points}});
  }
  return {{"name", use.source.name},    {"series", use.source.series}, {"plane", nameOf(use.source.view)},
          {"longAxis", use.longAxis},   {"weight", use.weight},        {"likeness", use.likeness},
          {"closureMm", use.closureMm}, {"apartMm", use.apartMm},      {"light", lightName(use.light)},
          {"reason", use.reason},       {"phases", std::move(phases)}};
}

ordered_json findingJson(const live::CineFinding& finding) {
  const auto number = [](const std::optional<std::size_t>& index) {
    return index ? ordered_json(*index) : ordered_json(nullptr);
  };
  return {{"light", lightName(finding.light)},
          {"text", finding.text},
          {"phase", number(finding.phase)},
          {"plane", number(finding.plane)}};
}

ordered_json correctionJson(const live::CorrectionOutcome& outcome) {
  return {{"phase", outcome.correction.phase},
          {"slice", outcome.correction.slice.value_or(0)},
          {"series", outcome.correction.series.value_or(0)},
          {"surface", outcome.correction.surface},
          {"beforeMm", outcome.met.beforeMm},
          {"mostMm", outcome.met.mostMm},
          {"met", outcome.met.met()}};
}

/// What is an estimate says so beside each number; a right ventricle has none.
void markEstimates(const CineMotion& found, ordered_json& json) {
  for (std::size_t phase = 0; phase < found.motion.phases.size(); ++phase)
    for (auto& [name, surface] : json["phases"][phase]["surfaces"].items()) {
      surface["estimate"] = !found.isLabelled(phase);
      if (!found.isLabelled(phase) && anatomy::chamberKey(name) == "rv")
        for (const char* key : {"volumeMl", "fittedMl", "freeMl"})
          surface[key] = nullptr;
    }
  for (const auto& [name, indices] : found.motion.indices) {
    json["indices"][name]["estimate"] = true;
    if (const std::string key = anatomy::chamberKey(name); !key.empty())
      json["indices"][key]["estimate"] = true;
  }
}

} // namespace

void CineTrackOptions::add(CLI::App& options) {
  options
      .add_option(
          "--images", images_,
          "Cine images of a whole cycle, in the place of PHASES: a folder of DICOM files, a 4D NIfTI or a "
          ".seq.nrrd; --phase labels some of its phases")
      ->type_name("STUDY");
  options
      .add_option(
          "--phase", phases_,
          "A phase of the images, the first is 0, and its labels: a label map, a surface or a folder of "
          "surfaces; once for each labelled phase, the ends of diastole and systole at least")
      ->type_name("N=FILE")
      ->expected(1)
      ->take_all();
  options
      .add_option("--leave-out-series", leftOutSeries_, "Series of the images not to use, by their numbers")
      ->type_name("N1,N2,...")
      ->delimiter(',');
  options
      .add_option("--correct", corrections_,
                  "Contours that the motion has to meet, whatever the images show: a file {\"corrections\": "
                  "[{\"phase\": 4, \"slice\": 2, \"surface\": \"RV\", \"pointsMm\": [[x, y, z], ...]}]}; "
                  "may be repeated")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
}

void CineTrackOptions::requireImages() const {
  if (!given() && (!phases_.empty() || !leftOutSeries_.empty() || !corrections_.empty()))
    throw UsageError("There are no images",
                     !phases_.empty()          ? "--phase"
                     : !leftOutSeries_.empty() ? "--leave-out-series"
                                               : "--correct",
                     "give them as in --images STUDY; labels of all phases need no --phase");
}

live::CineRequest CineTrackOptions::request() const {
  live::CineRequest request;
  request.images = images_;
  for (const std::string& phase : phases_)
    addLabels(phase, request.labels);
  request.leftOutSeries = leftOutSeries_;
  for (const std::string& file : corrections_)
    for (live::ContourCorrection& correction : live::readCorrections(file))
      request.corrections.push_back(std::move(correction));
  return request;
}

void addCineReport(const CineMotion& found, Outcome& outcome) {
  ordered_json& json = outcome.json;
  json["labelledPhases"] = found.labelled;
  json["estimate"] = found.estimate;
  for (std::size_t phase = 0; phase < found.motion.phases.size(); ++phase)
    json["phases"][phase]["labelled"] = found.isLabelled(phase);
  json["endDiastolePhase"] = found.endDiastole;
  json["endSystolePhase"] = found.estimate ? found.emptiest : found.endSystole;
  json["fullestPhase"] = found.fullest;
  json["emptiestPhase"] = found.emptiest;
  json["planes"] = ordered_json::array();
  for (const CinePlaneUse& use : found.planes)
    json["planes"].push_back(planeJson(use));
  json["findings"] = ordered_json::array();
  for (const live::CineFinding& finding : found.findings)
    json["findings"].push_back(findingJson(finding));
  json["corrections"] = ordered_json::array();
  for (const live::CorrectionOutcome& correction : found.corrections)
    json["corrections"].push_back(correctionJson(correction));
  if (found.estimate)
    markEstimates(found, json);
}

void addCineLines(const CineMotion& found, Listing& listing) {
  std::string labelled;
  for (const std::size_t phase : found.labelled)
    labelled += (labelled.empty() ? "" : ", ") + std::to_string(phase);
  listing.add("labelled", labelled + (found.estimate ? ": everything else is an estimate" : ""));
  for (const CinePlaneUse& use : found.planes)
    listing.add(use.source.name.english(), "weight " + fixed(use.weight, 2) + ", arrives " +
                                               fixed(use.closureMm, 1) + " mm from the next label, " +
                                               fixed(use.apartMm, 2) + " mm from the surfaces" +
                                               (use.reason.empty() ? "" : ": " + use.reason.english()));
  for (const live::CorrectionOutcome& each : found.corrections)
    listing.add("corrected", each.where.english() + ", phase " + std::to_string(each.correction.phase) +
                                 ": " + fixed(each.met.beforeMm, 1) + " mm away before, " +
                                 fixed(each.met.mostMm, 2) + " mm now");
}

} // namespace viscera::app::cli
