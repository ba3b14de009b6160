#include "viscera/live/cine_reading.h"

#include <algorithm>
#include <cmath>

#include "viscera/anatomy/norms.h"
#include "viscera/core/error.h"
#include "viscera/heart/heart_numbers.h"

namespace viscera::live {
namespace {

using tracking::FitLight;

constexpr double kWallAmber = 0.1, kWallRed = 0.2; ///< Beyond the labels' volumes, parts of them.

} // namespace

FitLight lightOf(PlaneState state) {
  return state == PlaneState::used || state == PlaneState::labelled ? FitLight::good : FitLight::amber;
}

Text wordsOf(const CinePlaneUse& plane, std::size_t phase) {
  if (phase >= plane.states.size())
    throw UsageError(misuse("the plane has no phase %1", phase));
  const tracking::PlaneShare& share = plane.shares[phase];
  const Text weight = phrase("weight %1 %", std::lround(100 * share.weight));
  switch (plane.states[phase]) {
  case PlaneState::used:
    return weight;
  case PlaneState::leavesPlane:
    return phrase("left its plane by %1 mm, %2", inFixed(share.closureMm, 1), weight);
  case PlaneState::unlike:
    return phrase("hardly alike, %1", weight);
  case PlaneState::noWall:
    return "shows no wall";
  case PlaneState::noImage:
    return "no image";
  case PlaneState::labelled:
    break;
  }
  return "labelled";
}

std::optional<std::size_t> planeOfSlice(const CineMotion& found, std::size_t slice) {
  for (std::size_t plane = 0; plane < found.planes.size(); ++plane)
    if (found.planes[plane].source.slice == slice)
      return plane;
  return std::nullopt;
}

std::optional<WallCheck> wallAt(const PatientMotion& motion, const CineMotion* found, std::size_t phase) {
  if (phase >= motion.tissueMl.size())
    return std::nullopt;
  WallCheck check{motion.tissueMl[phase], FitLight::good, {}};
  if (!found || found->labelled.empty())
    return check;
  double least = motion.tissueMl[found->labelled.front()], most = least;
  for (const std::size_t label : found->labelled) {
    least = std::min(least, motion.tissueMl[label]);
    most = std::max(most, motion.tissueMl[label]);
  }
  const double beyond = std::max(1 - check.ml / least, check.ml / most - 1);
  if (beyond <= kWallAmber)
    return check;
  check.light = beyond > kWallRed ? FitLight::red : FitLight::amber;
  check.reason = phrase("the tissue has %1 ml, in the labelled phases %2 to %3 ml", inFixed(check.ml, 1),
                        inFixed(least, 1), inFixed(most, 1));
  return check;
}

MotionSeries wholeCycle(const LabelledStudy& study, const CineMotion& found) {
  MotionSeries cycle;
  cycle.names = study.labels.names;
  cycle.outer = study.labels.outer;
  cycle.files = study.labels.files;
  cycle.times = study.times;
  for (const TrackedPhase& phase : found.motion.phases) {
    std::vector<double>& volumes = cycle.volumesMl.emplace_back();
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces)
      volumes.push_back(surface.measuredMl);
  }
  return cycle;
}

std::optional<double> statedBodySurface(const medical_io::CineStudy& study) {
  if (study.heightCm <= 0 || study.weightKg <= 0)
    return std::nullopt;
  const double surface = heart::bodySurfaceM2(study.heightCm, study.weightKg);
  return surface >= anatomy::kSmallestBodySurfaceM2 && surface <= anatomy::kLargestBodySurfaceM2
             ? std::optional(surface)
             : std::nullopt;
}

} // namespace viscera::live
