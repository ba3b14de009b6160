#include "viscera/motion/volume_kept_sequence.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::motion {

VolumeKeptSequence::VolumeKeptSequence(std::shared_ptr<const sequences::Sequence> moving,
                                       std::shared_ptr<const deformation::VolumeLock> lock,
                                       sequences::Curve volumeMl, std::vector<int> compensating,
                                       double limitMm)
    : moving_(std::move(moving)), lock_(std::move(lock)), volumeMl_(std::move(volumeMl)),
      compensating_(std::move(compensating)), limitMm_(limitMm) {
  assert(lock_->surfaces().size() == 1);
  assert(lock_->surfaces().front().binding->handleCount() == moving_->restHandles().rows());
  if (compensating_.empty()) {
    compensating_.resize(static_cast<std::size_t>(moving_->restHandles().rows()));
    std::iota(compensating_.begin(), compensating_.end(), 0);
  }
  for (int instant = 0; instant < kTriedInstants; ++instant) {
    const double fraction = static_cast<double>(instant) / kTriedInstants;
    const auto tried = restored(fraction, moving_->standardRatePerMinute());
    if (!tried.restored)
      throw DataError(std::to_string(std::lround(volumeMl_.at(fraction))) + " ml cannot be reached at " +
                          std::to_string(std::lround(100 * fraction)) + " % of the cycle: " + tried.reason,
                      moving_->name(),
                      "ask for a volume nearer to that at rest, or let more handles compensate");
  }
}

deformation::RestoredPose VolumeKeptSequence::restored(double fraction, double ratePerMinute) const {
  Points pose;
  moving_->poseAt(fraction * 60 / ratePerMinute, ratePerMinute, pose);
  const auto lock = lock_->withTargets({volumeMl_.at(fraction) * kMm3PerMl});
  return lock.restore(pose, compensating_, deformation::LeastDisplacement(), limitMm_);
}

void VolumeKeptSequence::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  const double cycles = seconds * ratePerMinute / 60;
  const double fraction = cycles - std::floor(cycles);
  auto found = restored(fraction, ratePerMinute);
  if (!found.restored)
    found = restored(std::floor(fraction * kTriedInstants) / kTriedInstants, ratePerMinute);
  pose = std::move(found.pose);
}

} // namespace viscera::motion
