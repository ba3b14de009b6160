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

TEST(ParallelPieces, AreEachDoneOnceWhateverTheWorks) {
  for (const int threads : {1, 2, 3}) {
    std::vector<std::vector<std::atomic<int>>> visits;
    std::vector<PiecesOfWork> works;
    for (const std::size_t count : {0, 3, 0, 0, 1, 40, 0})
      visits.emplace_back(count);
    for (auto& own : visits)
      works.push_back({static_cast<Eigen::Index>(own.size()),
                       [&own](Eigen::Index piece) { ++own.at(static_cast<std::size_t>(piece)); }});
    parallelPieces(works, {threads});
    for (const auto& own : visits)
      for (const auto& count : own)
        EXPECT_EQ(count.load(), 1);
  }
  parallelPieces({}, {2});
}

TEST(ParallelPieces, RethrowWhatOneThrows) {
  const PiecesOfWork fine{5, [](Eigen::Index) {}};
  const PiecesOfWork bad{5, [](Eigen::Index piece) {
                           if (piece == 3)
                             throw std::runtime_error("no");
                         }};
  EXPECT_THROW(parallelPieces({fine, bad, fine}, {2}), std::runtime_error);
}

TEST(ParallelPieces, WorksInTurnKeepTheirOrderInEachPiece) {
  std::vector<int> values(20, 1);
  const PiecesOfWork doubled{20, [&](Eigen::Index piece) { values[static_cast<std::size_t>(piece)] *= 2; }};
  const PiecesOfWork increased{20, [&](Eigen::Index piece) { ++values[static_cast<std::size_t>(piece)]; }};
  parallelPieces({inTurn({doubled, increased, doubled})}, {3});
  EXPECT_EQ(values, std::vector<int>(20, 6));
  EXPECT_EQ(inTurn({}).count, 0);
}

} // namespace
} // namespace viscera
