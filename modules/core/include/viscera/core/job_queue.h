#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/core/signal.h"

namespace viscera {

/// The result of a job: a value, an error, or nothing because it was cancelled or superseded.
template <class Value>
struct JobResult {
  std::optional<Value> value;
  std::shared_ptr<const Error> error; ///< Any other exception comes as an `Error` with exit code 70.
  bool cancelled() const { return !value && !error; }
};

/// Name and progress of a job that waits or runs, for the status bar.
struct JobInfo {
  std::int64_t id = 0;
  Text name;
  std::string slot;
  bool running = false;
  double fraction = 0; ///< 0 to 1.
  Text step;
};

/// Runs long jobs on worker threads. Everything but the work itself belongs to one thread, the main thread:
/// call the members there; results, progress and `onChange` are delivered there, through the function given
/// to the constructor.
class JobQueue {
public:
  /// Runs a function later on the main thread. Called from any thread; never calls the function at once.
  using Post = std::function<void(std::function<void()>)>;

  /// `workers` threads, at least one. More than one is rarely useful: the work itself uses all of the
  /// machine.
  explicit JobQueue(Post post, int workers = 1);
  /// Cancels all jobs and waits for the work to stop. No result is delivered after that, not even one that
  /// was posted.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  /// Queues `work`; `done` gets its result on the main thread, exactly once while the queue lives. A job with
  /// a slot that is not empty supersedes the one in the same slot: that one is cancelled, and its value is
  /// dropped even if it was ready, so that an old result never arrives after a newer job was queued. Returns
  /// the job's id.
  template <class Value>
  std::int64_t submit(Text name, std::string slot, std::function<Value(Progress&)> work,
                      std::function<void(JobResult<Value>)> done) {
    return submitAny(
        std::move(name), std::move(slot),
        [work = std::move(work)](Progress& progress) {
          return std::make_shared<std::optional<Value>>(work(progress));
        },
        [done = std::move(done)](std::shared_ptr<void> value, std::shared_ptr<const Error> error) {
          JobResult<Value> result;
          if (value)
            result.value = std::move(*std::static_pointer_cast<std::optional<Value>>(value));
          result.error = std::move(error);
          done(std::move(result));
        });
  }

  /// Requests a job to stop; its `done` gets a cancelled result. Nothing happens for one that has ended.
  void cancel(std::int64_t id);
  void cancelSlot(const std::string& slot);
  void cancelAll();

  /// The jobs that wait or run, oldest first.
  std::vector<JobInfo> jobs() const;
  bool idle() const { return jobs().empty(); }

  /// Calls `observer` on the main thread when `jobs()` has changed, including progress.
  [[nodiscard]] Subscription onChange(std::function<void()> observer);

private:
  using AnyWork = std::function<std::shared_ptr<void>(Progress&)>;
  using AnyDone = std::function<void(std::shared_ptr<void>, std::shared_ptr<const Error>)>;
  struct Shared;

  std::int64_t submitAny(Text name, std::string slot, AnyWork work, AnyDone done);

  std::shared_ptr<Shared> shared_;
};

/// Stands in for an event loop in programs without one, and in tests: keeps the posted functions until `run`
/// is called.
class ManualEventLoop {
public:
  ManualEventLoop();
  /// The argument for the constructor of `JobQueue`. The loop may be destroyed before the queue.
  JobQueue::Post post() const;
  /// Runs the posted functions on this thread; returns their number.
  int run();
  /// Runs posted functions until `done()` returns true.
  void runUntil(const std::function<bool()>& done);

private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

} // namespace viscera
