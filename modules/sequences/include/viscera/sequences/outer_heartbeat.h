#pragma once

#include <string>
#include <vector>

#include "viscera/sequences/cardiac_cycle.h"
#include "viscera/sequences/heart_motion.h"
#include "viscera/sequences/pose_compensation.h"
#include "viscera/sequences/sequence.h"
#include "viscera/sequences/volume_keeping.h"

namespace viscera::sequences {

/// The part of its volume that a whole heart loses in systole: 8.2 %, 4.8 to 10.6 (doi
/// 10.1152/ajpheart.01125.2003).
inline constexpr double kSystolicLoss = 0.082;

/// The beating of a heart of which only the outer surface is known: the motion of `HeartMotion`, and in every
/// pose the ventricles so wide that the whole surface holds `rest (1 - loss emptying)`. The handles are
/// affine in that width, so the volume is a cubic in it, whose root is exact at every instant and rate.
/// Thread-safe as far as `volume` is.
class OuterHeartbeat final : public Sequence {
public:
  /// Throws `DataError` when the compensation is for another number of handles, when the loss does not lie in
  /// [0, 0.4], or when the volume cannot be reached somewhere in the beat.
  OuterHeartbeat(HeartMotion motion, PoseCompensation compensation, VolumeAlong volume,
                 double systolicLoss = kSystolicLoss);

  std::string id() const override { return "heartbeat"; }
  std::string name() const override { return "Heartbeat"; }
  const Points& restHandles() const override { return rest_; }
  std::vector<HandleGroup> groups() const override { return motion_.rig().groups(); }
  double standardRatePerMinute() const override { return CardiacCycle::kStandardRateBpm; }
  double lowestRatePerMinute() const override { return CardiacCycle::kLowestRateBpm; }
  double highestRatePerMinute() const override { return CardiacCycle::kHighestRateBpm; }

  /// One call of `volume`, and O(n^2). Throws `DataError` when no width reaches the volume.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;
  std::vector<Phase> phases(double ratePerMinute) const override {
    return CardiacCycle::phases(ratePerMinute);
  }

  /// What the surface holds then, as a part of what it holds at rest.
  double volumePart(double seconds, double ratePerMinute) const;
  const HeartMotion& motion() const { return motion_; }

private:
  void poseAtPhase(double phase, Points& pose) const;

  HeartMotion motion_;
  CardiacCycle cycle_;
  PoseCompensation compensation_;
  VolumeAlong volume_;
  double loss_;
  Points rest_;
  double restMl_ = 0;
};

} // namespace viscera::sequences
