#pragma once

#include <functional>

#include <Eigen/Core>

namespace viscera {

/// The number of threads that a computation may use; 0 means all of the machine. No result may depend on it.
struct Threads {
  int count = 0;
  /// The number really used, at least 1.
  int resolved() const;
};

/// Calls `body(begin, end)` for consecutive ranges of at most `grain` indices that cover [0, count), on
/// several threads, in no particular order. The ranges do not depend on the number of threads. The first
/// exception that a body throws is rethrown here after all threads have stopped; none crosses the parallel
/// region.
void parallelRanges(Eigen::Index count, Eigen::Index grain, Threads threads,
                    const std::function<void(Eigen::Index begin, Eigen::Index end)>& body);

} // namespace viscera
