#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "viscera/core/progress.h"
#include "viscera/session/volume_record.h"

namespace viscera::app {

/// Hands frames from the thread that draws to the one that writes; a few may wait.
class FrameChannel {
public:
  /// Whether another frame may be handed over.
  bool hasRoom() const;
  /// A frame; null where only numbers are recorded.
  void push(vtkSmartPointer<vtkImageData> frame);
  /// There are no more frames; here are the volumes of all of them.
  void close(session::VolumeRecord volumes);
  /// The frames cannot be drawn any more.
  void fail();

  /// Waits for the next frame; empty after the last one. Throws `Cancelled` when somebody cancelled, or when
  /// the frames failed.
  std::optional<vtkSmartPointer<vtkImageData>> next(const Progress& progress);
  /// After the last frame.
  const session::VolumeRecord& volumes() const { return volumes_; }

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<vtkSmartPointer<vtkImageData>> frames_;
  bool closed_ = false;
  bool failed_ = false;
  session::VolumeRecord volumes_;
};

} // namespace viscera::app
