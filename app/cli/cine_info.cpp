#include "cli/cine_info.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "cli/listing.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/cine_study.h"

namespace viscera::app::cli {
namespace {

using medical_io::CineSlice;
using medical_io::CineStack;
using medical_io::CineStudy;
using nlohmann::ordered_json;

constexpr double kMsInSecond = 1000;

/// The slices of each series, in the order of the study.
std::vector<std::vector<const CineSlice*>> seriesOf(const CineStudy& study) {
  std::vector<std::vector<const CineSlice*>> all;
  for (const CineSlice& slice : study.slices) {
    if (all.empty() || all.back().front()->series != slice.series)
      all.emplace_back();
    all.back().push_back(&slice);
  }
  return all;
}

ordered_json cineSliceJson(const CineSlice& slice) {
  const medical_io::CineGeometry& place = slice.geometry;
  return {{"plane", nameOf(slice.plane)},
          {"centerMm", numbersJson(place.center())},
          {"originMm", numbersJson(place.origin)},
          {"rowDirection", numbersJson(place.row)},
          {"columnDirection", numbersJson(place.column)},
          {"phases", slice.fractions.size()},
          {"fractions", slice.fractions},
          {"missingFractions", slice.missing},
          {"intervalMs",
           slice.interval > 0 ? ordered_json(kMsInSecond * slice.interval) : ordered_json(nullptr)}};
}

ordered_json cineSeriesJson(const std::vector<const CineSlice*>& series) {
  const CineSlice& first = *series.front();
  ordered_json slices = ordered_json::array();
  for (const CineSlice* slice : series)
    slices.push_back(cineSliceJson(*slice));
  return {{"id", first.series},
          {"number", first.number},
          {"description", first.description},
          {"date", first.date},
          {"size", {first.geometry.columns, first.geometry.rows}},
          {"spacingMm", {first.geometry.betweenColumns, first.geometry.betweenRows}},
          {"thicknessMm", first.geometry.thickness},
          {"slices", slices}};
}

ordered_json cineStackJson(const CineStudy& study, const CineStack& stack) {
  ordered_json numbers = ordered_json::array();
  for (const std::size_t slice : stack.slices)
    numbers.push_back(study.slices[slice].number);
  return {{"plane", nameOf(study.slices[stack.slices.front()].plane)},
          {"slices", stack.slices},
          {"series", numbers},
          {"distancesMm", stack.distances},
          {"gapsMm", stack.gaps}};
}

std::string phasesText(const CineSlice& slice) {
  const std::string there = std::to_string(slice.fractions.size());
  return there + (slice.missing.empty() ? "" : " of " + std::to_string(slice.phasesInCycle())) + " phases" +
         (slice.interval > 0 ? " in " + significant(kMsInSecond * slice.interval, 4) + " ms" : "");
}

/// "cine 4CH, 4-chamber, 25 phases in 876 ms, 256 x 208 x 1, 1.406 x 1.406 x 6 mm, center -42.1 12.0 3.5".
std::string seriesText(const std::vector<const CineSlice*>& series) {
  const CineSlice& first = *series.front();
  const medical_io::CineGeometry& place = first.geometry;
  const Vec3 center = 0.5 * (place.center() + series.back()->geometry.center());
  return (first.description.empty() ? "" : first.description + ", ") + nameOf(first.plane) + ", " +
         phasesText(first) + ", " + std::to_string(place.columns) + " x " + std::to_string(place.rows) +
         " x " + std::to_string(series.size()) + ", " + significant(place.betweenColumns, 4) + " x " +
         significant(place.betweenRows, 4) + " x " + significant(place.thickness, 4) + " mm, center " +
         fixed(center.x(), 1) + " " + fixed(center.y(), 1) + " " + fixed(center.z(), 1);
}

/// "short axis, 17.7 17.7 mm apart, gaps 11.7 11.7 mm".
std::string stackText(const CineStudy& study, const CineStack& stack) {
  std::set<std::string> distances, gaps;
  for (const double distance : stack.distances)
    distances.insert(significant(distance, 3));
  for (const double gap : stack.gaps)
    gaps.insert(significant(gap, 3));
  const auto joined = [](const std::set<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts)
      all += (all.empty() ? "" : ", ") + text;
    return all;
  };
  return nameOf(study.slices[stack.slices.front()].plane) + ", " + std::to_string(stack.slices.size()) +
         " slices, " + joined(distances) + " mm apart, gaps of " + joined(gaps) + " mm";
}

std::optional<CineStudy> cineIn(const std::string& folder, CommandContext& context,
                                std::vector<Text>& warnings) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    return std::nullopt;
  try {
    return medical_io::findCineStudy(folder, context.progress);
  } catch (const DataError& error) {
    warnings.push_back(error.explanation());
    return std::nullopt;
  }
}

} // namespace

std::optional<Outcome> describeCine(const std::string& folder, CommandContext& context,
                                    std::vector<Text>& warnings) {
  const std::optional<CineStudy> study = cineIn(folder, context, warnings);
  if (!study)
    return std::nullopt;
  const std::vector<std::vector<const CineSlice*>> all = seriesOf(*study);
  if (all.size() < 2)
    return std::nullopt;
  Outcome outcome;
  outcome.warnings = study->findings;
  Listing listing;
  listing.add("kind", "cine study").add("modality", study->modality);
  if (!study->date.empty())
    listing.add("date", study->date);
  ordered_json series = ordered_json::array(), stacks = ordered_json::array();
  for (const auto& slices : all) {
    series.push_back(cineSeriesJson(slices));
    listing.add("  " + std::to_string(slices.front()->number), seriesText(slices));
  }
  for (const CineStack& stack : study->stacks) {
    stacks.push_back(cineStackJson(*study, stack));
    listing.add("stack", stackText(*study, stack));
  }
  outcome.json = {{"kind", "cine study"},
                  {"file", folder},
                  {"modality", study->modality},
                  {"date", study->date},
                  {"series", series},
                  {"stacks", stacks},
                  {"findings", study->findings},
                  {"warnings", outcome.warnings}};
  outcome.text = listing.text();
  return outcome;
}

} // namespace viscera::app::cli
