#pragma once

#include <string>
#include <vector>

#include "viscera/sequences/heartbeat_calibration.h"
#include "viscera/sequences/sequence.h"

namespace viscera::sequences {

/// One beat of a heart as somebody else has computed it (a circulation): what it is like at even instants.
struct HeartCourse {
  std::string name;                    ///< "Heartbeat: exercise"
  double period = 0;                   ///< s
  std::vector<CourseInstant> instants; ///< At 0, 1/n, 2/n ... of the beat.
  std::vector<Phase> phases;           ///< Covering [0, 1].

  /// Between two instants: linear. O(1).
  CourseInstant at(double phase) const;
};

/// The heart beating as a course says, so that its cavities hold the course's volumes at every instant. It
/// has one rate, that of the course: another rate is another course. Immutable; thread-safe.
class CourseHeartbeat final : public Sequence {
public:
  /// `calibration` is that of `calibrateCourse`. Throws `DataError` when the course has fewer than eight
  /// instants or no period, or when the calibration or the compensation do not fit.
  CourseHeartbeat(HeartMotion motion, HeartCourse course, PoseCompensation compensation,
                  const HeartbeatCalibration& calibration);

  std::string id() const override { return "heartbeat"; }
  std::string name() const override { return course_.name; }
  const Points& restHandles() const override { return rest_; }
  std::vector<HandleGroup> groups() const override { return motion_.rig().groups(); }
  double standardRatePerMinute() const override { return 60 / course_.period; }
  double lowestRatePerMinute() const override { return 60 / course_.period; }
  double highestRatePerMinute() const override { return 60 / course_.period; }
  std::vector<Phase> phases(double /*ratePerMinute*/) const override { return course_.phases; }

  /// O(n^2) with a compensation, else O(n).
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;

  const HeartCourse& heartCourse() const { return course_; }

private:
  HeartMotion motion_;
  HeartCourse course_;
  PoseCompensation compensation_;
  Curve leftGain_;
  Curve rightShift_;
  Points rest_;
};

/// The corrections of a calibration as curves over one beat. Throws `DataError` when they differ in length,
/// are fewer than eight or not finite.
struct CalibrationCurves {
  Curve leftGain;
  Curve rightShift;
};
CalibrationCurves calibrationCurves(const HeartbeatCalibration& calibration);

} // namespace viscera::sequences
