#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <vtkSmartPointer.h>

#include "viscera/core/progress.h"

class vtkImageData;

namespace viscera::scene {

/// Frame rate and quality of a movie.
struct MovieOptions {
  double framesPerSecond = 25;
  int quality = 2; ///< 0 small, 1 medium, 2 good.
};

/// Whether MP4 and GIF can be written: the program `ffmpeg` is on the PATH.
bool ffmpegInstalled();

/// Writes frames to a movie file while the next ones are being rendered: a worker thread encodes from a short
/// queue.
///
/// `.ogv` is Ogg Theora and needs nothing; `.mp4` and `.gif` go through the program `ffmpeg`; a path without
/// an extension is a folder for numbered PNG files (`frame_00000.png`). Movies are written to a temporary
/// name beside the file and renamed at the end; when the writer is destroyed unfinished, cancelled, or fails,
/// everything it wrote is removed. One thread at a time may call it.
class MovieWriter {
public:
  /// Throws `UsageError` for another extension or a rate that is not positive, `CannotCreateError` when the
  /// place cannot be written or ffmpeg is needed and missing (the message proposes .ogv).
  explicit MovieWriter(const std::filesystem::path& file, const MovieOptions& options = {});
  ~MovieWriter();
  MovieWriter(const MovieWriter&) = delete;
  MovieWriter& operator=(const MovieWriter&) = delete;

  /// Adds a frame (as returned by `grabPicture`; the writer keeps it, so do not change it). Waits when the
  /// queue is full. Throws what the worker has thrown, and `UsageError` for a frame of another size than the
  /// first.
  void add(vtkSmartPointer<vtkImageData> frame);

  /// Waits for the worker, closes and renames the movie. `progress` follows the frames still waiting and can
  /// cancel. Throws `CannotCreateError` when writing failed or no frame was added, `Cancelled`.
  void finish(Progress& progress);

  /// Stops and removes what was written. Nothing happens after `finish`.
  void cancel();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
