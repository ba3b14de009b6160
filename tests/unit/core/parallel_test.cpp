#include "viscera/core/parallel.h"

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace viscera {
namespace {

std::set<std::pair<Eigen::Index, Eigen::Index>> rangesWith(int threads) {
  std::mutex mutex;
  std::set<std::pair<Eigen::Index, Eigen::Index>> ranges;
  parallelRanges(1003, 10, {threads}, [&](Eigen::Index begin, Eigen::Index end) {
    const std::lock_guard lock(mutex);
    ranges.emplace(begin, end);
  });
  return ranges;
}

TEST(ParallelRanges, CoverEveryIndexOnce) {
  std::vector<std::atomic<int>> visits(1003);
  parallelRanges(1003, 7, {2}, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      ++visits[std::size_t(i)];
  });
  for (const auto& count : visits)
    EXPECT_EQ(count.load(), 1);
}

TEST(ParallelRanges, AreTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(rangesWith(1), rangesWith(2));
  EXPECT_EQ(rangesWith(1), rangesWith(5));
}

TEST(ParallelRanges, RethrowWhatABodyThrows) {
  for (int threads : {1, 3})
    EXPECT_THROW(parallelRanges(100, 1, {threads},
                                [](Eigen::Index begin, Eigen::Index) {
                                  if (begin == 42)
                                    throw std::out_of_range("42");
                                }),
                 std::out_of_range);
}

TEST(ParallelRanges, DoNothingForNoIndices) {
  parallelRanges(0, 8, {2}, [](Eigen::Index, Eigen::Index) { FAIL(); });
}

TEST(Threads, UsesWhatIsAskedForAndAtLeastOne) {
  EXPECT_EQ(Threads{3}.resolved(), 3);
  EXPECT_GE(Threads{}.resolved(), 1);
}

} // namespace
} // namespace viscera
