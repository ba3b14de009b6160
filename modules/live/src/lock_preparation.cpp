#include "lock_preparation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "viscera/core/background.h"

namespace viscera::live {
namespace {

using deformation::LockedSurface;
using deformation::VolumeLock;

} // namespace

bool sameSurfaces(const std::vector<LockedSurface>& a, const std::vector<LockedSurface>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.rest == y.rest && x.binding == y.binding; });
}

LockPreparation::LockPreparation(JobQueue& jobs, Threads threads)
    : jobs_(jobs), slot_("lock/" + std::to_string(reinterpret_cast<std::uintptr_t>(this))),
      threads_{std::max(1, threads.resolved() - 1)} {}

LockPreparation::~LockPreparation() {
  jobs_.cancelSlot(slot_);
}

void LockPreparation::want(std::vector<LockedSurface> surfaces, const VolumeLock* known) {
  keepOnly(surfaces);
  if (surfaces.empty() || sameSurfaces(surfaces, wanted_))
    return;
  wanted_ = surfaces;
  std::vector<std::shared_ptr<const VolumeLock>> others{ready_};
  if (known)
    others.push_back(std::make_shared<const VolumeLock>(*known));
  const auto work = [locked = std::move(surfaces), with = threads_,
                     others = std::move(others)](Progress& progress) {
    std::shared_ptr<const VolumeLock> lock;
    inBackground([&] {
      lock = std::make_shared<const VolumeLock>(locked, with, VolumeLock::Forms::whenAsked, others);
      lock->makeForms(progress);
    });
    return lock;
  };
  using Lock = std::shared_ptr<const VolumeLock>;
  jobs_.submit<Lock>("Preparing the volume lock", slot_, work,
                     [weak = weak_from_this()](JobResult<Lock> result) {
                       // The surfaces themselves are passed over where there is no value; a motion says what
                       // is wrong with them.
                       const auto alive = weak.lock();
                       if (alive && result.value)
                         alive->ready_ = std::move(*result.value);
                     });
}

void LockPreparation::keepOnly(const std::vector<LockedSurface>& surfaces) {
  if (sameSurfaces(surfaces, wanted_))
    return;
  jobs_.cancelSlot(slot_);
  wanted_.clear();
  if (surfaces.empty())
    ready_.reset();
}

} // namespace viscera::live
