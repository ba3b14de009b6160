#pragma once

#include "viscera/heart/heartbeat.h"

/// The heartbeat of a heart of which only the outer surface is known.
namespace viscera::heart {

/// The part of its volume that a whole heart loses in systole: 8.2 %, 4.8 to 10.6 (doi
/// 10.1152/ajpheart.01125.2003).
inline constexpr double kSystolicLoss = 0.082;

/// The heartbeat of a heart of which only the outer surface is known: the motion of `HeartMotion`, in which
/// the width of the ventricles is chosen in every pose so that the volume of the whole surface is `rest (1 -
/// loss emptying)`, with the emptying of the left ventricle. The handles are affine in that width, so the
/// volume is a cubic in it, whose root is exact at every instant and rate. Thread-safe as far as `volume` is.
class OuterHeartbeat final : public Heartbeat {
public:
  /// Throws `DataError` when the compensation is for another number of handles, when the loss does not lie in
  /// [0, 0.4], or when the volume cannot be reached somewhere in the beat.
  OuterHeartbeat(HeartMotion motion, sequences::PoseCompensation compensation, sequences::VolumeAlong volume,
                 double systolicLoss = kSystolicLoss);

  const Points& restHandles() const override { return rest_; }
  const HeartMotion& motion() const override { return motion_; }
  /// One call of `volume`, and O(n^2). Throws `DataError` when no width reaches the volume.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;

private:
  HeartMotion motion_;
  sequences::PoseCompensation compensation_;
  Points rest_;
  sequences::VolumeAlong volume_;
  double loss_;
  double restMl_ = 0;
};

} // namespace viscera::heart
