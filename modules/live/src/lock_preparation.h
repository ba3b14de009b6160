#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/core/job_queue.h"
#include "viscera/deformation/volume_lock.h"

/// Prepares volume locks on a worker, so that a drag can begin without waiting.
namespace viscera::live {

/// Whether two lists hold the same surfaces with the same bindings.
bool sameSurfaces(const std::vector<deformation::LockedSurface>& a,
                  const std::vector<deformation::LockedSurface>& b);

/// Makes a volume lock with its volume forms on the job queue before a motion needs it, because that may take
/// longer than a drag can wait. For the queue's main thread.
class LockPreparation : public std::enable_shared_from_this<LockPreparation> {
public:
  /// `jobs` must live longer. The worker leaves one of `threads` to the main thread where there are several.
  LockPreparation(JobQueue& jobs, Threads threads);
  ~LockPreparation();
  LockPreparation(const LockPreparation&) = delete;
  LockPreparation& operator=(const LockPreparation&) = delete;

  /// Begins to prepare these surfaces, and cancels the preparation of others. Nothing happens when they are
  /// under way or ready. `known` may be null, else all its forms have to be made; the worker uses a copy of
  /// it, so its targets may be changed.
  void want(std::vector<deformation::LockedSurface> surfaces, const deformation::VolumeLock* known);
  /// Cancels the preparation of other surfaces than these, and begins nothing.
  void keepOnly(const std::vector<deformation::LockedSurface>& surfaces);

  /// The last lock that was completed, perhaps of other surfaces than are wanted now; null without one.
  const std::shared_ptr<const deformation::VolumeLock>& ready() const { return ready_; }

private:
  JobQueue& jobs_;
  std::string slot_; ///< A slot of its own, so that dragging and playing do not cancel each other's jobs.
  Threads threads_;
  std::vector<deformation::LockedSurface> wanted_; ///< Under way, ready, or impossible.
  std::shared_ptr<const deformation::VolumeLock> ready_;
};

} // namespace viscera::live
