#include "viscera/live/moved_organs.h"

#include "sample_heart.h"
#include "viscera/core/error.h"
#include "viscera/document/rig.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::live {
namespace {

constexpr double kSecondsOfMinute = 60;
/// The cavity of the sample heart's left ventricle and that one's wall.
constexpr const char *kLeftVentricle = "lv", *kOwnWall = "lv_wall";

} // namespace

MovedOrgans movedOrgans(const SequenceFile& file, const coordinates::Registry& systems) {
  if (file.organs.empty())
    throw UsageError("It holds no organ", file.track.name.empty() ? "sequence" : file.track.name,
                     "name one with --organ");
  MovedOrgans moved;
  moved.organs = file.organs;
  moved.handles = document::handleSet(rigOf(file));
  const document::SystemChoice choice = file.system.value_or(document::SystemChoice());
  moved.system = systems.find(choice.id);
  moved.parameters = choice.parameters;
  for (const auto& key : file.track.keys) {
    moved.seconds.push_back(key.seconds);
    moved.poses.push_back(key.pose);
  }
  return moved;
}

MovedOrgans movedOrgans(const MotionSeries& series, const PatientMotion& found,
                        const coordinates::Registry& systems) {
  MovedOrgans moved = movedOrgans(found.sequence, systems);
  moved.corresponding = found.corresponding;
  for (const tracking::SurfaceSeries& surface : series.corresponding) {
    moved.measured.push_back(surface.phases);
    moved.rowOfGiven.push_back(surface.rowOfGiven);
  }
  return moved;
}

MovedOrgans movedOrgans(MotionRunner& runner, const coordinates::Registry& systems, int instants,
                        Progress& progress) {
  runner.requireMovable();
  const document::DocumentState& state = runner.state();
  MovedOrgans moved;
  for (const auto& organ : *state.organs)
    if (runner.organs().bound(organ->id))
      moved.organs.push_back({organ->name, organ->mesh});
  moved.handles = document::handleSet(*state.rig);
  moved.system = systems.find(state.system->id);
  moved.parameters = state.system->parameters;
  const double rate = runner.ratePerMinute();
  for (const double key : runner.sequence()->keys())
    moved.seconds.push_back(key * runner.sequence()->standardRatePerMinute() / rate);
  if (moved.seconds.empty()) {
    moved.corresponding = true; // A motion that is computed moves material points.
    for (int i = 0; i < instants; ++i)
      moved.seconds.push_back(i * kSecondsOfMinute / rate / instants);
  }
  for (const double seconds : moved.seconds) {
    progress.throwIfCancelled();
    const std::optional<Points> pose = runner.poseAt(seconds);
    if (!pose)
      throw DataError(runner.obstacle(), runner.sequence()->id());
    moved.poses.push_back(*pose);
  }
  return moved;
}

void addOwnWall(const document::DocumentState& state, Progress& progress, MovedOrgans& moved) {
  for (const auto& organ : *state.organs) {
    const auto resolution = heartResolutionOf(organ->origin);
    if (!resolution || organ->origin.surface != kLeftVentricle)
      continue;
    moved.wall = SequenceOrgan{
        kOwnWall, heartSurface(sample_organs::standardLibrary(), kOwnWall, *resolution, progress)};
    return;
  }
}

} // namespace viscera::live
