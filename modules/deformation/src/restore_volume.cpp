#include "viscera/deformation/restore_volume.h"

#include <algorithm>
#include <string>

#include "viscera/core/error.h"
#include "viscera/deformation/volume_lock.h"

namespace viscera::deformation {

std::vector<int> restingHandles(const Points& restHandles, const Points& pose) {
  std::vector<int> resting;
  for (Eigen::Index i = 0; i < restHandles.rows(); ++i)
    if (restHandles.row(i) == pose.row(i))
      resting.push_back(static_cast<int>(i));
  return resting;
}

void restoreVolume(Deformer& deformer, double targetMm3, const std::vector<int>& compensating,
                   const RestorationModel& model) {
  if (compensating.empty())
    throw UsageError("no handle is left to make up for the volume", {}, "name compensating handles");
  std::vector<int> free = compensating;
  std::sort(free.begin(), free.end());
  if (free.front() < 0 || free.back() >= deformer.pose().rows())
    throw UsageError("there is no handle " + std::to_string(free.front() < 0 ? free.front() : free.back()),
                     "compensating handles");
  const VolumeLock lock({{"organ", deformer.sharedRest(), deformer.sharedBinding(), targetMm3}});
  const double limit = boundsOf(deformer.restHandles()).diagonal();
  const auto restored = lock.restore(deformer.pose(), free, model, limit);
  if (!restored.restored)
    throw DataError(restored.reason, "volume",
                    "let more handles compensate, or ask for a volume nearer to the present one");
  deformer.setPose(restored.pose);
}

} // namespace viscera::deformation
