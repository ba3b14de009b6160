#pragma once

#include <functional>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/sequences/cardiac_cycle.h"
#include "viscera/sequences/heart_motion.h"
#include "viscera/sequences/pose_compensation.h"

namespace viscera::sequences {

/// What the cavities of a heart hold when its handles are at `pose` (`n x 3`).
using MeasureCavities = std::function<CavityVolumes(const Points& pose)>;

/// One motion's corrections over a beat, at reference phases 0, 1/n, 2/n, ...
struct HeartbeatCalibration {
  std::vector<double> leftGain;   ///< `HeartState::leftGain`
  std::vector<double> rightShift; ///< `HeartState::rightShift`
};

/// How near a calibration comes to the volumes asked for, ml.
inline constexpr double kLeftToleranceMl = 0.02;
inline constexpr double kRightToleranceMl = 0.05;

/// The state of the heart at a reference phase, without corrections.
HeartState uncorrectedState(const CardiacCycle& cycle, double phase);

/// Finds at `phases` instants the corrections with which the measured cavities hold what the cycle says,
/// within the tolerances: two equations by Broyden's method, each phase starting from the one before. Calls
/// `measure` about five times a phase. Throws `DataError` naming the phase where the volumes cannot be
/// reached, or are not finite; `Cancelled`.
HeartbeatCalibration calibrateHeartbeat(const HeartMotion& motion, const CardiacCycle& cycle,
                                        const PoseCompensation& compensation, const MeasureCavities& measure,
                                        Progress& progress, int phases = 96);

/// What a heart is to be like at one instant of its beat.
struct CourseInstant {
  HeartState state;      ///< Without corrections.
  CavityVolumes volumes; ///< What its cavities are to hold.
};

/// The same over the beat, for any phase in [0, 1); periodic.
using CourseOverPhase = std::function<CourseInstant(double phase)>;

/// As `calibrateHeartbeat`, for any course of the beat.
HeartbeatCalibration calibrateCourse(const HeartMotion& motion, const CourseOverPhase& course,
                                     const PoseCompensation& compensation, const MeasureCavities& measure,
                                     Progress& progress, int phases = 96);

} // namespace viscera::sequences
