#include "viscera/sequences/heartbeat.h"

#include <utility>

#include "viscera/core/error.h"
#include "viscera/sequences/course_heartbeat.h"

namespace viscera::sequences {

Heartbeat::Heartbeat(HeartMotion motion, CardiacCycle cycle, PoseCompensation compensation)
    : motion_(std::move(motion)), cycle_(std::move(cycle)), compensation_(std::move(compensation)),
      rest_(motion_.rig().restHandles()) {
  compensation_.requireFor(rest_.rows(), "heart", "heartbeat");
}

CalibratedHeartbeat::CalibratedHeartbeat(HeartMotion motion, CardiacCycle cycle,
                                         PoseCompensation compensation,
                                         const HeartbeatCalibration& calibration)
    : Heartbeat(std::move(motion), std::move(cycle), std::move(compensation)),
      leftGain_(calibrationCurves(calibration).leftGain),
      rightShift_(calibrationCurves(calibration).rightShift) {}

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
