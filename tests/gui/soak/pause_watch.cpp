#include "pause_watch.h"

#include <chrono>

#include <pthread.h>
#include <sched.h>

namespace viscera::tests {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kSleep{2};
constexpr double kShortestPauseMs = 1; ///< Less than that is the time to wake up.

/// Whether this thread now runs on that processor alone and before all others.
bool runFirstOn(int processor) {
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(processor, &only);
  if (pthread_setaffinity_np(pthread_self(), sizeof only, &only) != 0)
    return false;
  sched_param priority{};
  priority.sched_priority = sched_get_priority_min(SCHED_FIFO);
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0;
}

} // namespace

PauseWatch::PauseWatch() {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  for (int processor = 0; processor < processors; ++processor)
    threads_.emplace_back([this, processor] { watch(processor); });
}

PauseWatch::~PauseWatch() {
  stopping_ = true;
  for (std::thread& thread : threads_)
    thread.join();
}

void PauseWatch::watch(int processor) {
  if (!runFirstOn(processor))
    return;
  while (!stopping_) {
    const Clock::time_point before = Clock::now();
    std::this_thread::sleep_for(kSleep);
    const double lateMs = std::chrono::duration<double, std::milli>(Clock::now() - before - kSleep).count();
    if (lateMs < kShortestPauseMs)
      continue;
    double longest = longestMs_;
    while (lateMs > longest && !longestMs_.compare_exchange_weak(longest, lateMs)) {
    }
  }
}

} // namespace viscera::tests
