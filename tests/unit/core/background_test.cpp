#include "viscera/core/background.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include "viscera/core/error.h"
#include "viscera/core/parallel.h"

namespace viscera {
namespace {

TEST(Background, WorkIsDoneOnAnotherThreadWhenTheCallReturns) {
  const auto here = std::this_thread::get_id();
  std::thread::id there = here;
  inBackground([&] { there = std::this_thread::get_id(); });
  EXPECT_NE(there, here);
}

TEST(Background, WhatTheWorkThrowsArrives) {
  EXPECT_THROW(inBackground([] { throw DataError("too small"); }), DataError);
}

#if defined(__linux__)
int ownNiceness() {
  return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
}

TEST(Background, TheWorkAndItsThreadsGiveWayAndTheCallerDoesNot) {
  const int before = ownNiceness();
  std::atomic<int> least{100};
  inBackground([&] {
    parallelRanges(64, 1, Threads{3}, [&](Eigen::Index, Eigen::Index) {
      const int now = ownNiceness();
      for (int known = least; now < known && !least.compare_exchange_weak(known, now);) {
      }
    });
  });
  EXPECT_GE(least, 10);
  EXPECT_EQ(ownNiceness(), before);
}
#endif

} // namespace
} // namespace viscera
