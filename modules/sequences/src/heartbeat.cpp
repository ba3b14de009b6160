#include "viscera/sequences/heartbeat.h"

#include <utility>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

constexpr std::size_t kFewestPhases = 8;

/// A curve over one beat through values at even distances.
Curve overOneBeat(const std::vector<double>& values) {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < values.size(); ++i)
    keys.push_back({static_cast<double>(i) / static_cast<double>(values.size()), values[i]});
  return Curve::periodic(std::move(keys), 1.0);
}

const HeartbeatCalibration& checked(const HeartbeatCalibration& calibration) {
  const std::size_t count = calibration.leftGain.size();
  if (count < kFewestPhases || calibration.rightShift.size() != count)
    throw DataError("the calibration does not cover a beat", "heartbeat", "calibrate it again");
  return calibration;
}

} // namespace

Heartbeat::Heartbeat(HeartMotion motion, CardiacCycle cycle, PoseCompensation compensation)
    : motion_(std::move(motion)), cycle_(std::move(cycle)), compensation_(std::move(compensation)),
      rest_(motion_.rig().restHandles()) {
  compensation_.requireFor(rest_.rows(), "heart", "heartbeat");
}

CalibratedHeartbeat::CalibratedHeartbeat(HeartMotion motion, CardiacCycle cycle,
                                         PoseCompensation compensation,
                                         const HeartbeatCalibration& calibration)
    : Heartbeat(std::move(motion), std::move(cycle), std::move(compensation)),
      leftGain_(overOneBeat(checked(calibration).leftGain)),
      rightShift_(overOneBeat(calibration.rightShift)) {}

HeartState CalibratedHeartbeat::stateAtPhase(double phase) const {
  HeartState state = uncorrectedState(cycle_, phase);
  state.leftGain = leftGain_.at(phase);
  state.rightShift = rightShift_.at(phase);
  return state;
}

void CalibratedHeartbeat::poseAtPhase(double phase, Points& pose) const {
  motion_.pose(stateAtPhase(phase), pose);
  compensation_.apply(rest_, pose);
}

} // namespace viscera::sequences
