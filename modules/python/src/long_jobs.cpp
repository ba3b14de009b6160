#include "long_jobs.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <unistd.h>

namespace viscera::python {
namespace {

namespace py = pybind11;
using namespace std::chrono_literals;

/// What the job's thread and the caller's share.
struct Shared {
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  bool fresh = false; ///< The listener does not know of `fraction` and `step` yet.
  double fraction = 0;
  std::string step;
  std::exception_ptr failure;
};

/// Tells the listener and looks for Ctrl+C. Nothing, or what Python has raised; `Cancelled`, as an exception
/// of C++, when the listener has said `False`.
class Watcher {
public:
  Watcher(const py::object& listener, Progress& progress) : listener_(listener), progress_(progress) {}

  void look(bool fresh, double fraction, const std::string& step) {
    const py::gil_scoped_acquire locked;
    try {
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if (fresh && !progress_.cancelled() && !listener_.is_none()) {
        const py::object answer = listener_(fraction, step);
        if (py::isinstance<py::bool_>(answer) && !answer.cast<bool>())
          progress_.cancel();
      }
    } catch (py::error_already_set& error) {
      raised_.emplace(error);
      progress_.cancel();
    }
  }

  /// With the lock.
  void rethrow() {
    if (raised_)
      throw py::error_already_set(*raised_);
  }

private:
  const py::object& listener_;
  Progress& progress_;
  std::optional<py::error_already_set> raised_;
};

/// A thread that does one job after the other. It stays: a new one would have to make OpenMP's threads and
/// its part of the heap anew, which costs half a millisecond.
class Worker {
public:
  Worker() : thread_([this] { work(); }) {}
  ~Worker() {
    give(nullptr);
    if (process_ == getpid())
      thread_.join();
    else
      thread_.detach(); // A fork has copied this object, but no thread.
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  bool alive() const { return process_ == getpid(); }
  /// Null ends the thread. The one before has to be done.
  void give(std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
    given_ = true;
    wake_.notify_one();
  }

private:
  void work() {
    while (true) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return given_; });
      given_ = false;
      const auto job = std::exchange(job_, nullptr);
      lock.unlock();
      if (!job)
        return;
      job();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::function<void()> job_;
  bool given_ = false;
  const pid_t process_ = getpid();
  std::thread thread_; ///< Last: it works with all above.
};

/// The worker of the calling thread.
Worker& ownWorker() {
  thread_local std::unique_ptr<Worker> worker;
  if (!worker || !worker->alive())
    worker = std::make_unique<Worker>();
  return *worker;
}

void waitFor(Shared& shared, Watcher& watcher) {
  std::unique_lock lock(shared.mutex);
  bool done = false;
  while (!done) {
    done = shared.changed.wait_for(lock, 20ms, [&] { return shared.done; });
    const bool fresh = std::exchange(shared.fresh, false);
    const double fraction = shared.fraction;
    const std::string step = shared.step;
    lock.unlock();
    watcher.look(fresh, fraction, step);
    lock.lock();
  }
}

} // namespace

void runLong(const py::object& listener, const std::function<void(Progress&)>& job) {
  Shared shared;
  Progress::Listener hear;
  if (!listener.is_none())
    hear = [&](double fraction, const std::string& step) {
      const std::lock_guard lock(shared.mutex);
      shared.fraction = fraction;
      shared.step = step;
      shared.fresh = true;
    };
  Progress progress(std::move(hear)); // Where nobody listens, a job of milliseconds would feel the reports.
  Watcher watcher(listener, progress);
  {
    const py::gil_scoped_release released;
    ownWorker().give([&] {
      try {
        job(progress);
      } catch (...) {
        shared.failure = std::current_exception();
      }
      const std::lock_guard lock(shared.mutex);
      shared.done = true;
      shared.changed.notify_one();
    });
    waitFor(shared, watcher);
  }
  watcher.rethrow();
  if (shared.failure)
    std::rethrow_exception(shared.failure);
}

} // namespace viscera::python
