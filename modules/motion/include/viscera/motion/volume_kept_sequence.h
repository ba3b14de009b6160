#pragma once

#include <memory>
#include <vector>

#include "viscera/deformation/volume_lock.h"
#include "viscera/sequences/curve.h"
#include "viscera/sequences/sequence.h"

namespace viscera::motion {

/// A sequence whose organ has a prescribed volume at every instant, exactly: the other sequence's pose, after
/// which the compensating handles move by the least amount that gives the volume `V*(t)` (the root that locks
/// a drag). A constant curve locks the volume; a ventricle's filling curve makes any motion pump. The pose
/// of an instant does not depend on what was played before. Immutable, thread-safe.
class VolumeKeptSequence final : public sequences::Sequence {
public:
  /// How many instants of a cycle are tried when it is made.
  static constexpr int kTriedInstants = 64;

  /// `lock` holds one surface, bound to the sequence's handles. `volumeMl` maps the fraction of the cycle, 0
  /// to 1, to ml. `compensating` are rows of the handles, ascending; all of them when empty. `limitMm` is how
  /// far one may be moved. Throws `DataError` that names the first instant at which the volume cannot be
  /// reached. O(instants) restorations.
  VolumeKeptSequence(std::shared_ptr<const sequences::Sequence> moving,
                     std::shared_ptr<const deformation::VolumeLock> lock, sequences::Curve volumeMl,
                     std::vector<int> compensating, double limitMm);

  std::string id() const override { return moving_->id(); }
  std::string name() const override { return moving_->name(); }
  const Points& restHandles() const override { return moving_->restHandles(); }
  std::vector<sequences::HandleGroup> groups() const override { return moving_->groups(); }
  double standardRatePerMinute() const override { return moving_->standardRatePerMinute(); }
  double lowestRatePerMinute() const override { return moving_->lowestRatePerMinute(); }
  double highestRatePerMinute() const override { return moving_->highestRatePerMinute(); }
  std::vector<sequences::Phase> phases(double ratePerMinute) const override {
    return moving_->phases(ratePerMinute);
  }

  /// Where the volume cannot be reached between two tried instants, the pose of the tried one before it.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;

private:
  deformation::RestoredPose restored(double fraction, double ratePerMinute) const;

  std::shared_ptr<const sequences::Sequence> moving_;
  std::shared_ptr<const deformation::VolumeLock> lock_;
  sequences::Curve volumeMl_;
  std::vector<int> compensating_;
  double limitMm_;
};

} // namespace viscera::motion
