#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace viscera::tests {

/// Measures how long the machine itself stands still. A virtual machine has to wait when its host gives the
/// processors to others, which no counter inside it need tell. On each processor a thread sleeps for two
/// milliseconds, over and over, with a priority above everything else: only a processor that stands still can
/// wake it late. Without the right to such a priority, which root has, no pause is ever found.
///
///   PauseWatch watch;
///   ... a frame is drawn ...
///   const double standingMs = watch.takeLongestMs();
class PauseWatch {
public:
  PauseWatch();
  ~PauseWatch();
  PauseWatch(const PauseWatch&) = delete;
  PauseWatch& operator=(const PauseWatch&) = delete;

  /// The longest pause of a processor since the last call, ms; 0 when there was none.
  double takeLongestMs() { return longestMs_.exchange(0); }

private:
  void watch(int processor);

  std::atomic<bool> stopping_{false};
  std::atomic<double> longestMs_{0};
  std::vector<std::thread> threads_;
};

} // namespace viscera::tests
