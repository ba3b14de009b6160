#include "viscera/heart/heartbeat.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscera::heart {
namespace {

/// Instants of a beat at which the volumes are tried before a heart is there.
constexpr int kTriedOfABeat = 24;

} // namespace

BeatClock clockOf(const CardiacBeat& beat, double seconds) {
  const CardiacTimes& times = beat.times();
  return {seconds - beat.left().inletShuts, times.atrialSystole, 60 / times.cycle};
}

Text Heartbeat::rateRemark(double ratePerMinute) const {
  if (ratePerMinute >= kLowestMeasuredBpm && ratePerMinute <= kHighestMeasuredBpm)
    return {};
  return "Beyond the data: people were measured from 50 to 171 beats a minute";
}

CavityHeartbeat::CavityHeartbeat(CavityFit fit, CardiacCycle cycle) : Heartbeat(cycle), fit_(std::move(fit)) {
  Points pose;
  FoundCavities found;
  for (const double rate : {CardiacCycle::kStandardRateBpm, CardiacCycle::kHighestRateBpm})
    for (int i = 0; i < kTriedOfABeat; ++i) {
      const HeartInstant instant = heartInstant(cycle, cycle.at(i * 60 / rate / kTriedOfABeat, rate));
      fit_.pose(instant, pose, &found);
      solutions_.push_back({instant.volumes, found});
    }
}

const FoundCavities& CavityHeartbeat::nearestTo(const CavityVolumes& volumes) const {
  const auto away = [&](const Solution& solution) {
    return std::abs(solution.volumes.leftMl - volumes.leftMl) +
           std::abs(solution.volumes.rightMl - volumes.rightMl);
  };
  return std::min_element(solutions_.begin(), solutions_.end(),
                          [&](const Solution& a, const Solution& b) { return away(a) < away(b); })
      ->found;
}

void CavityHeartbeat::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  const HeartInstant instant = heartInstant(cycle(), cycle().at(seconds, ratePerMinute));
  FoundCavities start = nearestTo(instant.volumes);
  fit_.pose(instant, pose, &start);
}

} // namespace viscera::heart
