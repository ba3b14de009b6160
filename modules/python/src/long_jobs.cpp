#include "long_jobs.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

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
  Progress progress([&](double fraction, const std::string& step) {
    const std::lock_guard lock(shared.mutex);
    shared.fraction = fraction;
    shared.step = step;
    shared.fresh = true;
  });
  Watcher watcher(listener, progress);
  {
    const py::gil_scoped_release released;
    std::thread worker([&] {
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
    worker.join();
  }
  watcher.rethrow();
  if (shared.failure)
    std::rethrow_exception(shared.failure);
}

} // namespace viscera::python
