#include "viscera/heart/course_heartbeat.h"

#include <cmath>
#include <utility>

#include "mix.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"

namespace viscera::heart {
namespace {

constexpr std::size_t kFewestInstants = 8; ///< Instants.
/// Instants of the beat at which the volumes are tried beforehand.
constexpr int kTriedOfACourse = 24;
constexpr Eigen::Index kInARow = 6; ///< Each but the first of them begins where the one before ended.

HeartCourse checked(HeartCourse course) {
  if (course.instants.size() < kFewestInstants || !(course.period > 0))
    throw DataError(misuse("the course does not cover a beat"), course.name);
  if (!course.valves.empty() && course.valves.size() != course.instants.size())
    throw DataError(misuse("valves and volumes of the heartbeat have different times"), course.name);
  return course;
}

} // namespace

HeartInstant HeartCourse::at(double phase) const {
  const auto count = instants.size();
  const double place = (phase - std::floor(phase)) * static_cast<double>(count);
  const auto before = static_cast<std::size_t>(place) % count;
  const double part = place - std::floor(place);
  const HeartInstant& a = instants[before];
  const HeartInstant& b = instants[(before + 1) % count];
  HeartInstant now;
  now.state.emptying = mix(a.state.emptying, b.state.emptying, part);
  now.state.rightEmptying = mix(a.state.rightEmptying, b.state.rightEmptying, part);
  now.state.leftPart = mix(a.state.leftPart, b.state.leftPart, part);
  now.state.rightPart = mix(a.state.rightPart, b.state.rightPart, part);
  now.state.twist = mix(a.state.twist, b.state.twist, part);
  now.state.atrialContraction = mix(a.state.atrialContraction, b.state.atrialContraction, part);
  now.state.muscle = mix(a.state.muscle, b.state.muscle, part);
  const auto mixed = [&](const CavityVolumes& from, const CavityVolumes& to) {
    return CavityVolumes{mix(from.leftMl, to.leftMl, part), mix(from.rightMl, to.rightMl, part)};
  };
  now.volumes = mixed(a.volumes, b.volumes);
  if (a.atria && b.atria)
    now.atria = mixed(*a.atria, *b.atria);
  if (a.state.atria && b.state.atria)
    now.state.atria = AtrialState{mix(a.state.atria->leftPart, b.state.atria->leftPart, part),
                                  mix(a.state.atria->rightPart, b.state.atria->rightPart, part)};
  return now;
}

std::optional<ValveInstants> HeartCourse::valvesAt(double phase) const {
  if (valves.empty())
    return std::nullopt;
  const auto count = valves.size();
  const double place = (phase - std::floor(phase)) * static_cast<double>(count);
  const auto before = static_cast<std::size_t>(place) % count;
  const double part = place - std::floor(place);
  ValveInstants now = valves[before];
  const ValveInstants& next = valves[(before + 1) % count];
  for (std::size_t i = 0; i < kHeartValves; ++i)
    now[i] = {mix(now[i].areaMm2, next[i].areaMm2, part), mix(now[i].flowMlPerS, next[i].flowMlPerS, part)};
  return now;
}

std::optional<BeatClock> HeartCourse::clockAt(double phase) const {
  std::optional<BeatClock> now = begins;
  if (now)
    now->seconds += phase * period;
  return now;
}

CourseHeartbeat::CourseHeartbeat(CavityFit fit, HeartCourse course, Progress& progress)
    : fit_(std::move(fit)), course_(checked(std::move(course))) {
  progress.report(0, "calibrating the heartbeat");
  found_.resize(kTriedOfACourse);
  parallelRanges(kTriedOfACourse, kInARow, {}, [&](Eigen::Index begin, Eigen::Index end) {
    Points pose;
    FoundCavities found;
    for (Eigen::Index i = begin; i < end; ++i) {
      progress.throwIfCancelled();
      fit_.pose(course_.at(static_cast<double>(i) / kTriedOfACourse), pose, &found);
      found_[static_cast<std::size_t>(i)] = found;
    }
  });
  progress.report(1);
}

CourseHeartbeat::CourseHeartbeat(const CourseHeartbeat& similar, HeartCourse course)
    : fit_(similar.fit_), course_(checked(std::move(course))), found_(similar.found_) {}

void CourseHeartbeat::poseAt(double seconds, double /*ratePerMinute*/, Points& pose) const {
  const double phase = seconds / course_.period - std::floor(seconds / course_.period);
  FoundCavities start =
      found_[static_cast<std::size_t>(std::lround(phase * kTriedOfACourse)) % kTriedOfACourse];
  fit_.pose(course_.at(phase), pose, &start);
}

} // namespace viscera::heart
