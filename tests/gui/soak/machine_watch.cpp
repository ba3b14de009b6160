#include "machine_watch.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <random>

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>

namespace viscera::tests {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kSleep{2};
constexpr double kShortestPauseMs = 1; ///< Less than that is the time to wake up.
constexpr int kSleepsPerWork = 5;
constexpr int kFetches = 100;
constexpr std::uint32_t kPlaces = 1U << 21U; ///< 8 MB, more than a processor has for itself.

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

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

double milliseconds(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

/// What this process has used since it began.
MachineUse processUseUntilNow() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  MachineUse use;
  use.kernelMs = milliseconds(used.ru_stime);
  use.processMs = milliseconds(used.ru_utime) + use.kernelMs;
  use.pageFaults = used.ru_minflt;
  return use;
}

/// Independent sums over some numbers in the cache.
class Computing {
public:
  float operator()() const {
    constexpr std::size_t kSums = 8; // As wide as the processor's registers.
    float sums[kSums] = {};
    for (int round = 0; round < kRounds; ++round)
      for (std::size_t i = 0; i < numbers_.size(); i += kSums)
        for (std::size_t k = 0; k < kSums; ++k)
          sums[k] += numbers_[i + k] * sums[k] + 1;
    return std::accumulate(std::begin(sums), std::end(sums), 0.F);
  }

private:
  static constexpr int kRounds = 4;
  std::vector<float> numbers_ = std::vector<float>(1U << 14U, -0.5F);
};

/// One cycle through all places of a memory (Sattolo's shuffle): where the walk goes on is known only when a
/// place has been fetched.
const std::vector<std::uint32_t>& cycle() {
  static const std::vector<std::uint32_t> next = [] {
    std::vector<std::uint32_t> places(kPlaces);
    std::iota(places.begin(), places.end(), 0U);
    std::mt19937 random(1);
    for (std::uint32_t i = kPlaces - 1; i > 0; --i)
      std::swap(places[i], places[random() % i]);
    return places;
  }();
  return next;
}

class Fetching {
public:
  explicit Fetching(int first) : place_(next_[static_cast<std::size_t>(first)]) {}
  std::uint32_t operator()() {
    for (int i = 0; i < kFetches; ++i)
      place_ = next_[place_];
    return place_;
  }

private:
  const std::vector<std::uint32_t>& next_ = cycle();
  std::uint32_t place_;
};

} // namespace

MachineWatch::MachineWatch() : before_(processUseUntilNow()) {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  for (int processor = 0; processor < processors; ++processor)
    threads_.emplace_back([this, processor] { watch(processor); });
}

MachineWatch::~MachineWatch() {
  stopping_ = true;
  for (std::thread& thread : threads_)
    thread.join();
}

MachineUse MachineWatch::take() {
  Sums sums;
  {
    const std::lock_guard guard(mutex_);
    std::swap(sums, sums_);
  }
  const MachineUse now = processUseUntilNow();
  const MachineUse use = {sums.longestPauseMs, sums.workUs / std::max(1, sums.works),
                          now.processMs - before_.processMs, now.kernelMs - before_.kernelMs,
                          now.pageFaults - before_.pageFaults};
  before_ = now;
  return use;
}

void MachineWatch::watch(int processor) {
  Computing computing;
  Fetching fetching(processor);
  if (!runFirstOn(processor))
    return;
  for (int sleeps = 1; !stopping_; ++sleeps) {
    Clock::time_point begin = Clock::now();
    std::this_thread::sleep_for(kSleep);
    const double lateMs = millisecondsSince(begin) - static_cast<double>(kSleep.count());
    if (lateMs >= kShortestPauseMs) {
      const std::lock_guard guard(mutex_);
      sums_.longestPauseMs = std::max(sums_.longestPauseMs, lateMs);
    }
    if (sleeps % kSleepsPerWork != 0)
      continue;
    begin = Clock::now();
    const double result = computing() + static_cast<float>(fetching());
    const double workMs = millisecondsSince(begin);
    const std::lock_guard guard(mutex_);
    sums_.workUs += 1e3 * workMs;
    sums_.results += result;
    ++sums_.works;
  }
}

} // namespace viscera::tests
