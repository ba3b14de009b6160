#include "viscera/core/job_queue.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <thread>

#include "viscera/core/phrase.h"

namespace viscera {
namespace {

/// Between two attempts to post a result for which there was no memory.
constexpr std::chrono::milliseconds kPauseForMemory{20};

std::shared_ptr<const Error> asError(const std::exception& exception) {
  if (const auto* known = dynamic_cast<const Error*>(&exception))
    return std::make_shared<const Error>(*known);
  return std::make_shared<const Error>(kInternalError,
                                       phrase("Internal error: %1", std::string(exception.what())));
}

} // namespace

/// The state shared by the queue, its workers and the functions that it posted. `jobs`, `changed` and
/// `closed` belong to the main thread; `mutex` guards `waiting` and `stopping`.
struct JobQueue::Shared : std::enable_shared_from_this<JobQueue::Shared> {
  struct Job {
    std::int64_t id = 0;
    Text name;
    std::string slot;
    AnyWork work;
    AnyDone done;
    bool dropped = false; ///< Cancelled or superseded: whatever it ends with is thrown away.
    std::atomic<bool> running{false};
    std::unique_ptr<Progress> progress;
    std::mutex stepMutex; ///< Guards the two below.
    double fraction = 0;
    Text step;
  };
  using JobPointer = std::shared_ptr<Job>;

  Post post;
  /// Made in advance: to report that memory is short must not need any.
  const std::shared_ptr<const Error> shortMemory = std::make_shared<const Error>(notEnoughMemory());
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<JobPointer> waiting;
  bool stopping = false;
  std::atomic<bool> changePosted{false};

  std::vector<JobPointer> jobs;
  std::int64_t lastId = 0;
  bool closed = false;
  Signal<> changed;
  std::vector<std::thread> workers;

  void run();
  std::shared_ptr<void> resultOf(Job& job, std::shared_ptr<const Error>& error) const;
  void finish(const JobPointer& job, std::shared_ptr<void> value, std::shared_ptr<const Error> error);
  void deliver(const JobPointer& job, std::shared_ptr<void> value, std::shared_ptr<const Error> error);
  void drop(const JobPointer& job);
  void postChange();
};

void JobQueue::Shared::run() {
  for (;;) {
    JobPointer job;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [this] { return stopping || !waiting.empty(); });
      if (stopping)
        return;
      job = waiting.front();
      waiting.pop_front();
    }
    job->running = true;
    postChange();
    std::shared_ptr<const Error> error;
    std::shared_ptr<void> value = resultOf(*job, error);
    job->work = nullptr; // Frees here what the work held.
    finish(job, std::move(value), std::move(error));
  }
}

/// Does the work of a job. It throws nothing: `error` becomes what the work has thrown. A cancelled job has
/// neither a value nor an error.
std::shared_ptr<void> JobQueue::Shared::resultOf(Job& job, std::shared_ptr<const Error>& error) const {
  try {
    try {
      job.progress->throwIfCancelled();
      return job.work(*job.progress);
    } catch (const Cancelled&) {
      return nullptr;
    } catch (const std::exception& exception) {
      error = reportsShortMemory(exception) ? shortMemory : asError(exception);
    } catch (...) {
      error = std::make_shared<const Error>(kInternalError, "Internal error of an unknown kind");
    }
  } catch (const std::bad_alloc&) { // Not even the error's text fits into memory.
    error = shortMemory;
  }
  return nullptr;
}

/// Tries until there is memory for it: whoever waits for a job without a result waits for ever.
void JobQueue::Shared::finish(const JobPointer& job, std::shared_ptr<void> value,
                              std::shared_ptr<const Error> error) {
  for (;;) {
    try {
      return post([weak = weak_from_this(), job, value, error] {
        if (const auto alive = weak.lock())
          alive->deliver(job, value, error);
      });
    } catch (const std::bad_alloc&) {
      std::this_thread::sleep_for(kPauseForMemory);
    }
    const std::lock_guard lock(mutex);
    if (stopping) // Nobody wants it any more.
      return;
  }
}

void JobQueue::Shared::deliver(const JobPointer& job, std::shared_ptr<void> value,
                               std::shared_ptr<const Error> error) {
  if (closed)
    return;
  std::erase(jobs, job);
  if (job->dropped) {
    value.reset();
    error.reset();
  }
  const AnyDone done = std::move(job->done);
  done(std::move(value), std::move(error));
  if (!closed) // `done` may have destroyed the queue.
    changed.emit();
}

/// Main thread: the job's result is not wanted any more. One that has not begun ends here.
void JobQueue::Shared::drop(const JobPointer& job) {
  if (std::exchange(job->dropped, true))
    return;
  job->progress->cancel();
  bool waited = false;
  {
    const std::lock_guard lock(mutex);
    waited = std::erase(waiting, job) > 0;
  }
  if (waited)
    finish(job, nullptr, nullptr);
}

/// Any thread: at most one notice is under way at a time, however fast a job reports. One for which there is
/// no memory is left out.
void JobQueue::Shared::postChange() {
  if (changePosted.exchange(true))
    return;
  try {
    post([weak = weak_from_this()] {
      if (const auto alive = weak.lock()) {
        alive->changePosted = false;
        if (!alive->closed)
          alive->changed.emit();
      }
    });
  } catch (const std::bad_alloc&) {
    changePosted = false;
  }
}

JobQueue::JobQueue(Post post, int workers) : shared_(std::make_shared<Shared>()) {
  shared_->post = std::move(post);
  for (int i = 0; i < std::max(workers, 1); ++i)
    shared_->workers.emplace_back([shared = shared_.get()] { shared->run(); });
}

JobQueue::~JobQueue() {
  shared_->closed = true;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->stopping = true;
    shared_->waiting.clear();
  }
  for (const auto& job : shared_->jobs)
    job->progress->cancel();
  shared_->wake.notify_all();
  for (std::thread& worker : shared_->workers)
    worker.join();
}

std::int64_t JobQueue::submitAny(Text name, std::string slot, AnyWork work, AnyDone done) {
  const auto job = std::make_shared<Shared::Job>();
  job->id = ++shared_->lastId;
  job->name = std::move(name);
  job->slot = std::move(slot);
  job->work = std::move(work);
  job->done = std::move(done);
  // The job outlives its progress, and the shared part outlives every worker.
  job->progress = std::make_unique<Progress>(
      [shared = shared_.get(), raw = job.get()](double fraction, const Text& step) {
        {
          const std::lock_guard lock(raw->stepMutex);
          raw->fraction = fraction;
          raw->step = step;
        }
        shared->postChange();
      });
  if (!job->slot.empty())
    cancelSlot(job->slot);
  shared_->jobs.push_back(job);
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->waiting.push_back(job);
  }
  shared_->wake.notify_one();
  shared_->changed.emit();
  return job->id;
}

void JobQueue::cancel(std::int64_t id) {
  for (const auto& job : shared_->jobs)
    if (job->id == id)
      shared_->drop(job);
}

void JobQueue::cancelSlot(const std::string& slot) {
  for (const auto& job : shared_->jobs)
    if (job->slot == slot)
      shared_->drop(job);
}

void JobQueue::cancelAll() {
  for (const auto& job : shared_->jobs)
    shared_->drop(job);
}

std::vector<JobInfo> JobQueue::jobs() const {
  std::vector<JobInfo> list;
  for (const auto& job : shared_->jobs) {
    if (job->dropped)
      continue;
    const std::lock_guard lock(job->stepMutex);
    list.push_back({job->id, job->name, job->slot, job->running, job->fraction, job->step});
  }
  return list;
}

Subscription JobQueue::onChange(std::function<void()> observer) {
  return shared_->changed.connect(std::move(observer));
}

struct ManualEventLoop::Shared {
  std::mutex mutex;
  std::condition_variable arrived;
  std::deque<std::function<void()>> functions;
};

ManualEventLoop::ManualEventLoop() : shared_(std::make_shared<Shared>()) {}

JobQueue::Post ManualEventLoop::post() const {
  return [shared = shared_](std::function<void()> function) {
    {
      const std::lock_guard lock(shared->mutex);
      shared->functions.push_back(std::move(function));
    }
    shared->arrived.notify_one();
  };
}

int ManualEventLoop::run() {
  std::deque<std::function<void()>> functions;
  {
    const std::lock_guard lock(shared_->mutex);
    functions.swap(shared_->functions);
  }
  for (const auto& function : functions)
    function();
  return static_cast<int>(functions.size());
}

void ManualEventLoop::runUntil(const std::function<bool()>& done) {
  while (!done()) {
    if (run() > 0)
      continue;
    std::unique_lock lock(shared_->mutex);
    shared_->arrived.wait(lock, [this] { return !shared_->functions.empty(); });
  }
}

} // namespace viscera
