#include "viscera/sequences/heartbeat.h"

#include <utility>

namespace viscera::sequences {
namespace {

/// Instants of a beat at which the volumes are tried before a heart is there.
constexpr int kTriedOfABeat = 24;

} // namespace

std::string Heartbeat::rateRemark(double ratePerMinute) const {
  if (ratePerMinute >= kLowestMeasuredBpm && ratePerMinute <= kHighestMeasuredBpm)
    return {};
  return "Beyond the data: people were measured from 50 to 171 beats a minute";
}

CavityHeartbeat::CavityHeartbeat(CavityFit fit, CardiacCycle cycle) : Heartbeat(cycle), fit_(std::move(fit)) {
  Points pose;
  for (const double rate : {CardiacCycle::kStandardRateBpm, CardiacCycle::kHighestRateBpm})
    for (int i = 0; i < kTriedOfABeat; ++i)
      poseAt(i * 60 / rate / kTriedOfABeat, rate, pose);
}

void CavityHeartbeat::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  fit_.pose(heartInstant(cycle(), cycle().at(seconds, ratePerMinute)), pose);
}

} // namespace viscera::sequences
