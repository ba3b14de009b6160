#include "viscera/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <utility>

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

void parallelPieces(const std::vector<PiecesOfWork>& works, Threads threads) {
  std::vector<Eigen::Index> ends; // The pieces of all works are counted through.
  Eigen::Index count = 0;
  for (const PiecesOfWork& work : works)
    ends.push_back(count += work.count);
  parallelRanges(count, 1, threads, [&](Eigen::Index piece, Eigen::Index) {
    const auto end = std::upper_bound(ends.begin(), ends.end(), piece);
    const PiecesOfWork& work = works[static_cast<std::size_t>(end - ends.begin())];
    work.run(piece - (*end - work.count));
  });
}

PiecesOfWork inTurn(std::vector<PiecesOfWork> works) {
  if (works.empty())
    return {};
  if (works.size() == 1)
    return std::move(works.front());
  const Eigen::Index count = works.front().count;
  for ([[maybe_unused]] const PiecesOfWork& work : works)
    assert(work.count == count);
  return {count, [works = std::move(works)](Eigen::Index piece) {
            for (const PiecesOfWork& work : works)
              work.run(piece);
          }};
}

} // namespace viscera
