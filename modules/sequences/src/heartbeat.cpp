#include "viscera/sequences/heartbeat.h"

#include <utility>

#include "viscera/core/error.h"
#include "viscera/sequences/course_heartbeat.h"

namespace viscera::sequences {

CalibratedHeartbeat::CalibratedHeartbeat(HeartMotion motion, CardiacCycle cycle,
                                         PoseCompensation compensation,
                                         const HeartbeatCalibration& calibration)
    : motion_(std::move(motion)), cycle_(std::move(cycle)), compensation_(std::move(compensation)),
      leftGain_(calibrationCurves(calibration).leftGain),
      rightShift_(calibrationCurves(calibration).rightShift), rest_(motion_.rig().restHandles()) {
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
