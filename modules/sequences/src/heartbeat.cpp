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

CalibratedHeartbeat::CalibratedHeartbeat(HeartMotion motion, CardiacCycle cycle,
                                         PoseCompensation compensation,
                                         const HeartbeatCalibration& calibration)
    : motion_(std::move(motion)), cycle_(std::move(cycle)), compensation_(std::move(compensation)),
      leftGain_(overOneBeat(checked(calibration).leftGain)), rightShift_(overOneBeat(calibration.rightShift)),
      rest_(motion_.rig().restHandles()) {
  if (compensation_.handleCount() != 0 && compensation_.handleCount() != rest_.rows())
    throw DataError("the compensation is for " + std::to_string(compensation_.handleCount()) +
                        " handles, the heart has " + std::to_string(rest_.rows()),
                    "heartbeat");
}

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

void CalibratedHeartbeat::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  poseAtPhase(cycle_.referencePhase(seconds, ratePerMinute), pose);
}

CavityVolumes CalibratedHeartbeat::volumesAt(double seconds, double ratePerMinute) const {
  return cycle_.volumes(cycle_.referencePhase(seconds, ratePerMinute));
}

} // namespace viscera::sequences
