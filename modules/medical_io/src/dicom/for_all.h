#pragma once

#include <atomic>
#include <cstddef>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"

namespace viscera::medical_io {

/// Calls `job(i)` for every i on several threads; says how far it is, and stops when told to.
template <class Job>
void forAll(std::size_t count, Progress& progress, double from, double to, const Text& step, const Job& job) {
  std::atomic<std::size_t> done = 0;
  parallelRanges(static_cast<Eigen::Index>(count), 1, {}, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      progress.throwIfCancelled();
      job(static_cast<std::size_t>(i));
      progress.report(from + (to - from) * double(++done) / double(count), step);
    }
  });
}

} // namespace viscera::medical_io
