#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace viscera::tests {

/// What the machine itself did during a while.
struct MachineUse {
  double pausedMs = 0; ///< The longest pause of a processor.
  double workUs = 0;   ///< The mean time that the same small work took on the processors; 0 when none did it.
  double processMs = 0; ///< Processor time that this process used, over all its threads.
  double kernelMs = 0;  ///< What of that the kernel used for it.
  long pageFaults = 0;  ///< Pages that the kernel gave to this process.
};

/// Measures how long the machine stands still, and how fast it is. A virtual machine has to wait when its
/// host gives the processors to others, and shares caches and memory with others, which no counter inside it
/// need tell. On each processor a thread sleeps for two milliseconds, over and over, with a priority above
/// everything else: only a processor that stands still can wake it late. Each fifth time it does a small work
/// that is always the same, on memory of its own: a tenth of a millisecond. Without the right to such a
/// priority, which root has, it finds neither pauses nor slowness.
///
///   MachineWatch watch;
///   ... a frame is drawn ...
///   const MachineUse use = watch.take();
class MachineWatch {
public:
  MachineWatch();
  ~MachineWatch();
  MachineWatch(const MachineWatch&) = delete;
  MachineWatch& operator=(const MachineWatch&) = delete;

  /// Since the last call.
  MachineUse take();

private:
  struct Sums {
    double longestPauseMs = 0, workUs = 0;
    int works = 0;
    double results = 0; ///< Without them the compiler would leave out the work.
  };

  void watch(int processor);

  std::atomic<bool> stopping_{false};
  std::mutex mutex_; ///< Of `sums_`.
  Sums sums_;
  MachineUse before_; ///< Of the process since it began, when `take` was called last.
  std::vector<std::thread> threads_;
};

} // namespace viscera::tests
