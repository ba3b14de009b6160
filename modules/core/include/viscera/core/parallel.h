#pragma once

#include <functional>
#include <vector>

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
///
///     Eigen::VectorXd lengths(points.rows());
///     parallelRanges(points.rows(), 1024, {}, [&](Eigen::Index begin, Eigen::Index end) {
///       for (Eigen::Index i = begin; i < end; ++i)
///         lengths[i] = points.row(i).norm();
///     });
void parallelRanges(Eigen::Index count, Eigen::Index grain, Threads threads,
                    const std::function<void(Eigen::Index begin, Eigen::Index end)>& body);

/// Work that falls into pieces which do not depend on one another: they may be done in any order, on any
/// threads.
struct PiecesOfWork {
  Eigen::Index count = 0;
  std::function<void(Eigen::Index piece)> run; ///< Does one of [0, count).
};

/// Does all pieces of all works in one parallel loop, in no particular order. For many small works: a loop
/// for each of them would spend most of its time in starting and joining the threads. Exceptions as in
/// `parallelRanges`.
void parallelPieces(const std::vector<PiecesOfWork>& works, Threads threads);

/// Works on the same pieces as one: a piece of it does that piece of each work, in their order. All must have
/// as many pieces as the first one.
PiecesOfWork inTurn(std::vector<PiecesOfWork> works);

} // namespace viscera
