#include "cli/pose_strain.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/live/strain_reading.h"
#include "viscera/presentation/segment_map.h"
#include "viscera/presentation/strain_figure.h"
#include "viscera/strain/aha_segments.h"

namespace viscera::app::cli {
namespace {

using live::StrainDirection;
using live::StrainMoment;

constexpr std::pair<const char*, StrainDirection> kDirections[] = {
    {"longitudinal", StrainDirection::longitudinal},
    {"circumferential", StrainDirection::circumferential},
    {"radial", StrainDirection::radial},
    {"thickening", StrainDirection::thickening}};
constexpr std::size_t kPosed = 1; ///< The phase of the pose; rest is phase 0.

live::MovedOrgans movedBy(const StillOrgans& organs, const document::Rig& rig, const Points& pose,
                          const std::shared_ptr<const coordinates::CoordinateSystem>& system,
                          const coordinates::ParameterValues& parameters, Progress& progress) {
  live::MovedOrgans moved;
  for (const auto& organ : *organs.state().organs)
    moved.organs.push_back({organ->name, organ->mesh});
  if (std::none_of(moved.organs.begin(), moved.organs.end(), [](const live::SequenceOrgan& organ) {
        return anatomy::chamberNamed(organ.name) == anatomy::kLeftVentricle;
      }))
    throw DataError("No surface is a left ventricle by its name", "--strain", "name its cavity's file LV");
  moved.handles = document::handleSet(rig);
  moved.system = system;
  moved.parameters = parameters;
  moved.seconds = {0, 1};
  moved.poses = {moved.handles.positions, pose};
  moved.corresponding = true;
  live::addOwnWall(organs.state(), progress, moved);
  return moved;
}

} // namespace

std::vector<std::string> strainDirectionNames() {
  std::vector<std::string> names;
  for (const auto& [name, direction] : kDirections)
    names.emplace_back(name);
  return names;
}

PoseStrain strainOfPose(const StillOrgans& organs, const document::Rig& rig, const Points& pose,
                        const std::shared_ptr<const coordinates::CoordinateSystem>& system,
                        const coordinates::BindOptions& options, const std::string& direction,
                        Progress& progress) {
  const auto* chosen = std::find_if(std::begin(kDirections), std::end(kDirections),
                                    [&direction](const auto& known) { return direction == known.first; });
  const live::MovedOrgans moved = movedBy(organs, rig, pose, system, options.parameters, progress);
  const live::StrainGauge gauge(moved, {}, progress, options.threads);
  const live::StrainReading reading = gauge.read(moved, progress, options.threads, 0);
  const scene::BullsEyeFigure figure =
      presentation::strainBullsEye(reading, chosen->second, StrainMoment::instant, kPosed);
  presentation::SegmentsOfOrgans segments;
  for (std::size_t i = 0; i < moved.organs.size(); ++i)
    if (!gauge.segmentsOn(i).empty())
      segments[organs.idOf(i)] = gauge.segmentsOn(i);
  PoseStrain strain;
  strain.map = presentation::segmentMap(figure, segments, 0, figure.title);
  strain.json = {{"direction", direction}, {"segments", nlohmann::ordered_json::array()}};
  for (const strain::Segment& segment : strain::segments()) {
    const std::optional<double> percent =
        live::strainValue(reading, segment.number, chosen->second, StrainMoment::instant, kPosed);
    strain.json["segments"].push_back(
        {{"number", segment.number},
         {"percent", percent ? nlohmann::ordered_json(*percent) : nlohmann::ordered_json(nullptr)}});
  }
  strain.warnings = reading.warnings;
  return strain;
}

} // namespace viscera::app::cli
