#pragma once

#include <string>
#include <vector>

#include "viscera/sequences/heartbeat_calibration.h"
#include "viscera/sequences/sequence.h"

namespace viscera::sequences {

/// What beating hearts have in common, whatever is known of them.
class Heartbeat : public Sequence {
public:
  std::string id() const override { return "heartbeat"; }
  std::string name() const override { return "Heartbeat"; }
  const Points& restHandles() const override { return rest_; }
  std::vector<HandleGroup> groups() const override { return motion_.rig().groups(); }
  double standardRatePerMinute() const override { return CardiacCycle::kStandardRateBpm; }
  double lowestRatePerMinute() const override { return CardiacCycle::kLowestRateBpm; }
  double highestRatePerMinute() const override { return CardiacCycle::kHighestRateBpm; }

  /// As `poseAtPhase`.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override {
    poseAtPhase(cycle_.referencePhase(seconds, ratePerMinute), pose);
  }
  std::vector<Phase> phases(double ratePerMinute) const override {
    return CardiacCycle::phases(ratePerMinute);
  }
  /// The pose at a reference phase (see `CardiacCycle`).
  virtual void poseAtPhase(double phase, Points& pose) const = 0;

  const CardiacCycle& cycle() const { return cycle_; }
  const HeartMotion& motion() const { return motion_; }

protected:
  /// Throws `DataError` when the compensation is for another number of handles.
  Heartbeat(HeartMotion motion, CardiacCycle cycle, PoseCompensation compensation);

  HeartMotion motion_;
  CardiacCycle cycle_;
  PoseCompensation compensation_;
  Points rest_;
};

/// The beating heart: its handles' poses over time, such that the cavities of the heart it was calibrated on
/// hold what the cycle says, at every instant and rate. Thread-safe.
class CalibratedHeartbeat final : public Heartbeat {
public:
  /// Throws `DataError` when the calibration's two lists differ in length, are shorter than eight or not
  /// finite, or when the compensation is for another number of handles.
  CalibratedHeartbeat(HeartMotion motion, CardiacCycle cycle, PoseCompensation compensation,
                      const HeartbeatCalibration& calibration);

  /// O(n^2) with a compensation, else O(n).
  void poseAtPhase(double phase, Points& pose) const override;
  /// The state of the heart at a reference phase, corrections included.
  HeartState stateAtPhase(double phase) const;

private:
  Curve leftGain_;
  Curve rightShift_;
};

} // namespace viscera::sequences
