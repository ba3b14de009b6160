#include "viscera/live/contour_corrections.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;

constexpr double kCoveredMm = 3;
constexpr double kOffPlaneMm = 1; ///< At which a point is still taken as one of the plane.

double offPlane(const StudySlice& slice, const Points& points) {
  double most = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    most = std::max(most, std::abs(slice.plane.height(points.row(i).transpose())));
  return most;
}

/// The slice whose plane has the points, among those that are named.
std::size_t sliceOf(const LabelledStudy& study, const ContourCorrection& correction, const Text& where) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < study.slices.size(); ++i) {
    if ((correction.slice && *correction.slice != i) ||
        (correction.series && *correction.series != study.slices[i].series))
      continue;
    if (const double off = offPlane(study.slices[i], correction.points); off < least) {
      least = off;
      nearest = i;
    }
  }
  if (!nearest && correction.slice)
    throw UsageError(phrase("The images have no slice %1", *correction.slice), where,
                     phrase("their slices are 0 to %1", study.slices.size() - 1));
  if (!nearest)
    throw UsageError(phrase("The images have no series %1", correction.series.value_or(0)), where,
                     "viscera info lists the series of a study");
  if (least > kOffPlaneMm)
    throw UsageError(phrase("The corrected contour lies %1 mm beside the plane of %2", inFixed(least, 1),
                            study.slices[*nearest].name),
                     where, "give points in the plane of one slice, mm in LPS");
  return *nearest;
}

std::size_t surfaceIn(const LabelledStudy& study, const std::string& name, const Text& where) {
  const auto& names = study.labels.names;
  if (name.empty() && names.size() == 1)
    return 0;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string known;
    for (const std::string& each : names)
      known += (known.empty() ? "" : ", ") + each;
    throw UsageError(phrase("There is no surface \"%1\"", name), where, phrase("use one of: %1", known));
  }
  return static_cast<std::size_t>(found - names.begin());
}

} // namespace

ContourCorrection resolved(const LabelledStudy& study, const ContourCorrection& correction) {
  const std::size_t number = correction.phase + study.firstPhase;
  const Text where = phrase("correction of phase %1", number);
  if (correction.phase >= study.times.count())
    throw UsageError(
        phrase("The images have no phase %1", number), where,
        phrase("their phases are %1 to %2", study.firstPhase, study.times.count() - 1 + study.firstPhase));
  if (std::binary_search(study.phases.begin(), study.phases.end(), correction.phase))
    throw UsageError(
        phrase("Phase %1 has labels, which are exact: only phases between them are corrected", number), where,
        "change its labels, or leave this correction out");
  if (correction.points.rows() == 0 || !correction.points.allFinite())
    throw UsageError("A corrected contour has no points", where, "give three numbers for each of them, mm");
  ContourCorrection found = correction;
  found.surface = study.labels.names[surfaceIn(study, correction.surface, where)];
  found.slice = sliceOf(study, correction, where);
  found.series = study.slices[*found.slice].series;
  return found;
}

std::vector<tracking::CorrectedContour> correctedContours(const LabelledStudy& study,
                                                          const std::vector<ContourCorrection>& corrections) {
  std::vector<tracking::CorrectedContour> contours;
  for (const ContourCorrection& correction : corrections) {
    const ContourCorrection found = resolved(study, correction);
    contours.push_back(
        {found.phase, surfaceIn(study, found.surface, {}), study.slices[*found.slice].plane, found.points});
  }
  return contours;
}

std::vector<ContourCorrection> withCorrection(std::vector<ContourCorrection> corrections,
                                              const ContourCorrection& added, const Points& covered) {
  const auto same = std::find_if(corrections.begin(), corrections.end(), [&](const ContourCorrection& each) {
    return each.phase == added.phase && each.slice == added.slice && each.surface == added.surface;
  });
  if (same == corrections.end()) {
    corrections.push_back(added);
    return corrections;
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < same->points.rows(); ++i)
    if (covered.rows() == 0 ||
        (covered.rowwise() - same->points.row(i)).rowwise().norm().minCoeff() > kCoveredMm)
      kept.push_back(i);
  Points joined(static_cast<Eigen::Index>(kept.size()) + added.points.rows(), 3);
  joined.topRows(static_cast<Eigen::Index>(kept.size())) = same->points(kept, Eigen::all);
  joined.bottomRows(added.points.rows()) = added.points;
  same->points = std::move(joined);
  return corrections;
}

document::CorrectedContour stored(const ContourCorrection& correction) {
  document::CorrectedContour contour{static_cast<std::int64_t>(correction.phase),
                                     static_cast<std::int64_t>(correction.slice.value_or(0)),
                                     correction.surface,
                                     {}};
  for (Eigen::Index i = 0; i < correction.points.rows(); ++i)
    contour.points.emplace_back(correction.points.row(i).transpose());
  return contour;
}

ContourCorrection restored(const document::CorrectedContour& correction) {
  ContourCorrection contour;
  contour.phase = static_cast<std::size_t>(correction.phase);
  contour.slice = static_cast<std::size_t>(correction.slice);
  contour.surface = correction.surface;
  contour.points.resize(static_cast<Eigen::Index>(correction.points.size()), 3);
  for (std::size_t i = 0; i < correction.points.size(); ++i)
    contour.points.row(static_cast<Eigen::Index>(i)) = correction.points[i].transpose();
  return contour;
}

std::vector<std::size_t> phasesThatDiffer(const CineMotion& a, const CineMotion& b) {
  std::vector<std::size_t> phases;
  const auto &before = a.motion.sequence.track.keys, &after = b.motion.sequence.track.keys;
  for (std::size_t phase = 0; phase < std::min(before.size(), after.size()); ++phase)
    if (before[phase].pose.rows() != after[phase].pose.rows() || before[phase].pose != after[phase].pose)
      phases.push_back(phase);
  return phases;
}

ordered_json toJson(const std::vector<ContourCorrection>& corrections) {
  ordered_json list = ordered_json::array();
  for (const ContourCorrection& correction : corrections) {
    ordered_json item{{"phase", correction.phase}};
    if (correction.slice)
      item["slice"] = *correction.slice;
    if (correction.series)
      item["series"] = *correction.series;
    if (!correction.surface.empty())
      item["surface"] = correction.surface;
    item["pointsMm"] = ordered_json::array();
    for (Eigen::Index i = 0; i < correction.points.rows(); ++i)
      item["pointsMm"].push_back(jsonOf(Vec3(correction.points.row(i).transpose())));
    list.push_back(std::move(item));
  }
  return list;
}

std::vector<ContourCorrection> correctionsFrom(const JsonReader& reader, const ordered_json& object,
                                               const std::string& place) {
  std::vector<ContourCorrection> corrections;
  reader.eachOf(object, "corrections", place, [&](const ordered_json& item, const std::string& at) {
    reader.requireObject(item, at);
    ContourCorrection& correction = corrections.emplace_back();
    correction.phase = static_cast<std::size_t>(
        reader.wholeOf(reader.field(item, "phase", at), JsonReader::inside(at, "phase")));
    if (item.contains("slice"))
      correction.slice =
          static_cast<std::size_t>(reader.wholeOf(item.at("slice"), JsonReader::inside(at, "slice")));
    if (item.contains("series"))
      correction.series = reader.valueOf<int>(item, "series", at);
    reader.readIfThere(item, "surface", at, correction.surface);
    const auto points = reader.valueOf<std::vector<Vec3>>(item, "pointsMm", at);
    correction.points.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
      correction.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  });
  return corrections;
}

std::vector<ContourCorrection> readCorrections(const std::filesystem::path& file) {
  const JsonReader reader(
      file.string(),
      phrase("as in %1",
             R"({"corrections": [{"phase": 4, "surface": "RV", "pointsMm": [[x, y, z], ...]}]})"));
  const ordered_json content = reader.parse(readText(file));
  reader.requireObject(content, "");
  reader.listOf(content, "corrections", "");
  return correctionsFrom(reader, content, "");
}

} // namespace viscera::live
