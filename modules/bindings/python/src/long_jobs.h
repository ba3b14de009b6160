#pragma once

#include <functional>
#include <utility>

#include <pybind11/pybind11.h>

#include "viscera/core/progress.h"

namespace viscera::python {

/// Runs a job that may take long on the calling thread, without the interpreter's lock. When the job reports
/// progress or checks cancellation, that thread takes the lock, at most some fifty times a second, calls
/// `listener` (`None`, or a callable that takes fraction and step), and checks for Ctrl+C. KeyboardInterrupt,
/// an exception of the listener, or `False` from it ends the job. Rethrows what the job threw. Call it with
/// the lock held.
void runLong(const pybind11::object& listener, const std::function<void(Progress&)>& job);

/// The same for a job with a result.
template <typename Job>
auto resultOfLong(const pybind11::object& listener, Job job) {
  decltype(job(std::declval<Progress&>())) result{};
  runLong(listener, [&](Progress& progress) { result = job(progress); });
  return result;
}

/// Runs a job of some milliseconds on the calling thread, without the lock.
template <typename Job>
auto unlocked(Job job) {
  const pybind11::gil_scoped_release released;
  return job();
}

} // namespace viscera::python
