#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/core/job_queue.h"
#include "viscera/deformation/volume_lock.h"

namespace viscera::live {

/// Whether two locks are of the same surfaces as bound in the same way.
bool sameSurfaces(const std::vector<deformation::LockedSurface>& a,
                  const std::vector<deformation::LockedSurface>& b);

/// Makes a volume lock with its volume forms on the job queue, before a motion needs it: that may take longer
/// than a drag can wait. For the queue's main thread.
class LockPreparation : public std::enable_shared_from_this<LockPreparation> {
public:
  /// `jobs` must live longer. The worker leaves one of `threads` to the main thread where there are several.
  LockPreparation(JobQueue& jobs, Threads threads);
  ~LockPreparation();
  LockPreparation(const LockPreparation&) = delete;
  LockPreparation& operator=(const LockPreparation&) = delete;

  /// Begins to prepare these surfaces, and gives up what is under way for others. Nothing happens when they
  /// are the ones under way or ready. `known` may be null, else its forms are all made; the worker looks at
  /// a copy, so it may be given other targets.
  void want(std::vector<deformation::LockedSurface> surfaces, const deformation::VolumeLock* known);
  /// Gives up what is under way for other surfaces than these, and begins nothing.
  void keepOnly(const std::vector<deformation::LockedSurface>& surfaces);

  /// The last lock that was completed, perhaps of other surfaces than are wanted now; null without one.
  const std::shared_ptr<const deformation::VolumeLock>& ready() const { return ready_; }

private:
  JobQueue& jobs_;
  std::string slot_; ///< Of its own: who drags and who plays do not give up each other's work.
  Threads threads_;
  std::vector<deformation::LockedSurface> wanted_; ///< Under way, ready, or impossible.
  std::shared_ptr<const deformation::VolumeLock> ready_;
};

} // namespace viscera::live
