#include "viscera/scene/movie_writer.h"

#include <cassert>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include <vtkImageData.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

#include "image_sinks.h"

namespace viscera::scene {
namespace {

/// Frames that may wait: enough to even out slow ones, few enough for large pictures.
constexpr std::size_t kQueueLength = 8;
constexpr std::chrono::milliseconds kProgressInterval{50};
constexpr const char* kMovieStep = "writing the movie";

} // namespace

struct MovieWriter::Parts {
  std::unique_ptr<ImageSink> sink;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<vtkSmartPointer<vtkImageData>> queue;
  bool noMore = false;
  bool stop = false;
  bool idle = false; ///< The worker has ended.
  enum class State {
    writing,
    finished,
    cancelled
  } state = State::writing; ///< Only the caller's side looks at it.
  std::exception_ptr failure;
  int added = 0;
  int written = 0;
  int size[2] = {0, 0};
  std::thread worker;

  void work();
  void encode();
  void endWorker(bool stopNow);
  void throwFailure();
  bool waitForWorker(Progress& progress);
};

void MovieWriter::Parts::work() {
  try {
    encode();
  } catch (...) {
    const std::scoped_lock lock(mutex);
    failure = std::current_exception();
  }
  const std::scoped_lock lock(mutex);
  idle = true;
  changed.notify_all();
}

void MovieWriter::Parts::encode() {
  for (;;) {
    vtkSmartPointer<vtkImageData> frame;
    {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return stop || noMore || !queue.empty(); });
      if (stop)
        return;
      if (queue.empty())
        break;
      frame = queue.front();
    }
    sink->write(frame);
    const std::scoped_lock lock(mutex);
    queue.pop_front();
    ++written;
    changed.notify_all();
  }
  sink->close();
}

void MovieWriter::Parts::endWorker(bool stopNow) {
  {
    const std::scoped_lock lock(mutex);
    noMore = true;
    stop = stop || stopNow;
    changed.notify_all();
  }
  if (worker.joinable())
    worker.join();
}

void MovieWriter::Parts::throwFailure() {
  if (failure)
    std::rethrow_exception(failure);
}

MovieWriter::MovieWriter(const std::filesystem::path& file, const MovieOptions& options)
    : parts_(std::make_unique<Parts>()) {
  parts_->sink = imageSink(file, options);
  parts_->worker = std::thread([parts = parts_.get()] { parts->work(); });
}

MovieWriter::~MovieWriter() {
  cancel();
}

void MovieWriter::add(vtkSmartPointer<vtkImageData> frame) {
  auto& p = *parts_;
  assert(p.state == Parts::State::writing);
  const int* size = frame->GetDimensions();
  if (p.added == 0) {
    p.size[0] = size[0];
    p.size[1] = size[1];
  } else if (size[0] != p.size[0] || size[1] != p.size[1]) {
    throw UsageError(
        misuse("the frames of a movie have to be of one size: this one is %1 x %2, the first was %3 x %4",
               size[0], size[1], p.size[0], p.size[1]));
  }
  std::unique_lock lock(p.mutex);
  p.changed.wait(lock, [&] { return p.idle || p.queue.size() < kQueueLength; });
  p.throwFailure();
  p.queue.push_back(std::move(frame));
  ++p.added;
  p.changed.notify_all();
}

/// Waits until the worker has ended or the job is cancelled; true when the movie is complete.
bool MovieWriter::Parts::waitForWorker(Progress& progress) {
  if (progress.cancelled())
    return false;
  std::unique_lock lock(mutex);
  noMore = true;
  changed.notify_all();
  while (!changed.wait_for(lock, kProgressInterval, [this] { return idle; })) {
    const double part = double(written) / added;
    lock.unlock();
    progress.report(part, kMovieStep);
    lock.lock();
    if (progress.cancelled())
      return false;
  }
  return !failure;
}

void MovieWriter::finish(Progress& progress) {
  auto& p = *parts_;
  if (p.state == Parts::State::finished)
    return;
  if (p.state == Parts::State::cancelled)
    throw Cancelled();
  if (p.added == 0) {
    cancel();
    throw CannotCreateError("the movie has no frame");
  }
  if (!p.waitForWorker(progress)) {
    cancel();
    p.throwFailure();
    throw Cancelled();
  }
  p.endWorker(false);
  p.state = Parts::State::finished;
  progress.report(1, kMovieStep);
}

void MovieWriter::cancel() {
  auto& p = *parts_;
  if (p.state != Parts::State::writing)
    return;
  p.endWorker(true);
  p.sink->discard();
  p.state = Parts::State::cancelled;
}

} // namespace viscera::scene
