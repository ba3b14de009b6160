#include "window/recording/frame_channel.h"

#include <chrono>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::app {
namespace {
constexpr std::size_t kMostWaiting = 4;
constexpr std::chrono::milliseconds kLook{50}; ///< How soon a cancellation is seen.
} // namespace

bool FrameChannel::hasRoom() const {
  const std::scoped_lock lock(mutex_);
  return frames_.size() < kMostWaiting;
}

void FrameChannel::push(vtkSmartPointer<vtkImageData> frame) {
  const std::scoped_lock lock(mutex_);
  frames_.push_back(std::move(frame));
  changed_.notify_all();
}

void FrameChannel::close(session::VolumeRecord volumes) {
  const std::scoped_lock lock(mutex_);
  volumes_ = std::move(volumes);
  closed_ = true;
  changed_.notify_all();
}

void FrameChannel::fail() {
  const std::scoped_lock lock(mutex_);
  failed_ = true;
  changed_.notify_all();
}

std::optional<vtkSmartPointer<vtkImageData>> FrameChannel::next(const Progress& progress) {
  std::unique_lock lock(mutex_);
  while (frames_.empty() && !closed_ && !failed_ && !progress.cancelled())
    changed_.wait_for(lock, kLook);
  if (failed_ || progress.cancelled())
    throw Cancelled();
  if (frames_.empty())
    return std::nullopt;
  vtkSmartPointer<vtkImageData> frame = std::move(frames_.front());
  frames_.pop_front();
  return frame;
}

} // namespace viscera::app
