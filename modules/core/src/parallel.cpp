#include "viscera/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>

#include <omp.h>

namespace viscera {

int Threads::resolved() const {
  return count > 0 ? count : std::max(1, omp_get_max_threads());
}

void parallelRanges(Eigen::Index count, Eigen::Index grain, Threads threads,
                    const std::function<void(Eigen::Index, Eigen::Index)>& body) {
  assert(grain > 0);
  const Eigen::Index ranges = (count + grain - 1) / grain;
  const int team = static_cast<int>(std::min<Eigen::Index>(threads.resolved(), ranges));
  if (team <= 1) {
    for (Eigen::Index begin = 0; begin < count; begin += grain)
      body(begin, std::min(count, begin + grain));
    return;
  }
  std::exception_ptr first;
  std::atomic<bool> failed{false};
#pragma omp parallel for schedule(dynamic, 1) num_threads(team)
  for (Eigen::Index range = 0; range < ranges; ++range) {
    if (failed.load(std::memory_order_relaxed))
      continue;
    try {
      body(range * grain, std::min(count, (range + 1) * grain));
    } catch (...) {
      if (!failed.exchange(true))
        first = std::current_exception();
    }
  }
  if (first)
    std::rethrow_exception(first);
}

} // namespace viscera
