#pragma once

#include <atomic>
#include <functional>
#include <mutex>

#include "viscera/core/phrase.h"

namespace viscera {

/// Progress and cancellation of a long job: the job reports its progress, and the code that started it may
/// cancel it. Every member may be called from any thread.
class Progress {
public:
  /// Called with a fraction in [0, 1] and the name of the present step; calls never overlap.
  using Listener = std::function<void(double fraction, const Text& step)>;
  /// Called whenever the job looks whether it was cancelled, on the thread that looks, from several at a
  /// time: for a waiting side that has no thread of its own. It must be cheap and must not throw; it may call
  /// `cancel()`.
  using Look = std::function<void()>;

  Progress() = default;
  explicit Progress(Listener listener, Look look = {});

  /// Calls the listener, at most once for each per mille of progress or new step name.
  void report(double fraction, const Text& step = {});

  /// Requests the job to stop; it throws `Cancelled` when it checks next.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const {
    if (look_)
      look_();
    return cancelled_.load(std::memory_order_relaxed) || (whole_ && whole_->cancelled());
  }

  /// Throws `Cancelled` if `cancel` was called.
  void throwIfCancelled() const;

private:
  friend void runPart(Progress&, double, double, const std::function<void(Progress&)>&);

  Listener listener_;
  Look look_;
  std::mutex mutex_;
  double lastFraction_ = -1;
  Text lastStep_;
  std::atomic<bool> cancelled_{false};
  const Progress* whole_ = nullptr; ///< Of which this is a part.
};

/// Runs a part of a job as [from, to] of `progress`; cancelling goes through.
void runPart(Progress& progress, double from, double to, const std::function<void(Progress& part)>& job);

} // namespace viscera
