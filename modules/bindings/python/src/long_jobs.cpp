#include "long_jobs.h"

#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace viscera::python {
namespace {

namespace py = pybind11;
using namespace std::chrono_literals;

/// Between a job that runs without the lock and Python: a thread of OpenMP may report, but only the caller's
/// thread calls the listener and may look for signals.
class Watcher {
public:
  explicit Watcher(const py::object& listener)
      : listener_(listener), progress_(hearing(), [this] { lookNowAndThen(); }) {}

  Progress& progress() { return progress_; }

  /// Passes new progress to the listener, and checks for Ctrl+C. On the caller's thread.
  void look() {
    const py::gil_scoped_acquire locked;
    try {
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      tell();
    } catch (py::error_already_set& error) {
      raised_.emplace(error);
      end();
    }
    last_ = Clock::now();
  }

  /// Rethrows the exception raised in Python. Call it with the lock.
  void rethrow() {
    if (raised_)
      throw py::error_already_set(*raised_);
  }

private:
  using Clock = std::chrono::steady_clock;

  Progress::Listener hearing() {
    if (listener_.is_none()) // A job of milliseconds would feel the reports.
      return {};
    return [this](double fraction, const Text& step) {
      {
        const std::lock_guard lock(mutex_);
        fraction_ = fraction;
        step_ = step.english();
        fresh_ = true;
      }
      lookNowAndThen();
    };
  }

  void lookNowAndThen() {
    if (std::this_thread::get_id() == caller_ && !ended_ && Clock::now() - last_ >= 20ms)
      look();
  }

  void tell() {
    std::unique_lock lock(mutex_);
    if (ended_ || !std::exchange(fresh_, false))
      return;
    const double fraction = fraction_;
    const std::string step = step_;
    lock.unlock();
    const py::object answer = listener_(fraction, step);
    if (py::isinstance<py::bool_>(answer) && !answer.cast<bool>())
      end();
  }

  void end() {
    ended_ = true;
    progress_.cancel();
  }

  const py::object& listener_;
  const std::thread::id caller_ = std::this_thread::get_id();
  Clock::time_point last_ = Clock::now();
  bool ended_ = false; ///< Python code has ended the job.
  std::optional<py::error_already_set> raised_;
  std::mutex mutex_;   ///< Of what follows.
  bool fresh_ = false; ///< The listener does not know of `fraction_` and `step_` yet.
  double fraction_ = 0;
  std::string step_;
  Progress progress_; ///< Last: it calls the above.
};

} // namespace

void runLong(const py::object& listener, const std::function<void(Progress&)>& job) {
  Watcher watcher(listener);
  std::exception_ptr failure;
  {
    const py::gil_scoped_release released;
    try {
      job(watcher.progress());
    } catch (...) {
      failure = std::current_exception();
    }
    watcher.look();
  }
  watcher.rethrow();
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace viscera::python
