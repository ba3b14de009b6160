#include "viscera/sequences/course_heartbeat.h"

#include <cmath>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

constexpr std::size_t kFewest = 8; ///< Instants, and phases of a calibration.

double mix(double from, double to, double part) {
  return from + part * (to - from);
}

/// A curve over one beat through values at even distances.
Curve overOneBeat(const std::vector<double>& values) {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < values.size(); ++i)
    keys.push_back({static_cast<double>(i) / static_cast<double>(values.size()), values[i]});
  return Curve::periodic(std::move(keys), 1.0);
}

HeartCourse checked(HeartCourse course) {
  if (course.instants.size() < kFewest || !(course.period > 0))
    throw DataError("the course does not cover a beat", course.name);
  return course;
}

} // namespace

CalibrationCurves calibrationCurves(const HeartbeatCalibration& calibration) {
  const std::size_t count = calibration.leftGain.size();
  if (count < kFewest || calibration.rightShift.size() != count)
    throw DataError("the calibration does not cover a beat", "heartbeat", "calibrate it again");
  return {overOneBeat(calibration.leftGain), overOneBeat(calibration.rightShift)};
}

CourseInstant HeartCourse::at(double phase) const {
  const auto count = instants.size();
  const double place = (phase - std::floor(phase)) * static_cast<double>(count);
  const auto before = static_cast<std::size_t>(place) % count;
  const double part = place - std::floor(place);
  const CourseInstant& a = instants[before];
  const CourseInstant& b = instants[(before + 1) % count];
  CourseInstant now;
  now.state.emptying = mix(a.state.emptying, b.state.emptying, part);
  now.state.leftPart = mix(a.state.leftPart, b.state.leftPart, part);
  now.state.rightPart = mix(a.state.rightPart, b.state.rightPart, part);
  now.state.twist = mix(a.state.twist, b.state.twist, part);
  now.state.atrialContraction = mix(a.state.atrialContraction, b.state.atrialContraction, part);
  now.volumes = {mix(a.volumes.leftMl, b.volumes.leftMl, part),
                 mix(a.volumes.rightMl, b.volumes.rightMl, part)};
  return now;
}

CourseHeartbeat::CourseHeartbeat(HeartMotion motion, HeartCourse course, PoseCompensation compensation,
                                 const HeartbeatCalibration& calibration)
    : motion_(std::move(motion)), course_(checked(std::move(course))), compensation_(std::move(compensation)),
      leftGain_(calibrationCurves(calibration).leftGain),
      rightShift_(calibrationCurves(calibration).rightShift), rest_(motion_.rig().restHandles()) {
  if (compensation_.handleCount() != 0 && compensation_.handleCount() != rest_.rows())
    throw DataError("the compensation is for " + std::to_string(compensation_.handleCount()) +
                        " handles, the heart has " + std::to_string(rest_.rows()),
                    "heartbeat");
}

void CourseHeartbeat::poseAt(double seconds, double /*ratePerMinute*/, Points& pose) const {
  const double phase = seconds / course_.period;
  HeartState state = course_.at(phase).state;
  state.leftGain = leftGain_.at(phase);
  state.rightShift = rightShift_.at(phase);
  motion_.pose(state, pose);
  compensation_.apply(rest_, pose);
}

} // namespace viscera::sequences
