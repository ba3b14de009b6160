#pragma once

#include <filesystem>
#include <memory>

#include "viscera/scene/movie_writer.h"

class vtkImageData;

namespace viscera::scene {

/// The interface for encoders that write the frames of a movie. Used by one thread. Throws
/// `CannotCreateError`.
class ImageSink {
public:
  virtual ~ImageSink() = default;
  virtual void write(vtkImageData* frame) = 0;
  /// Completes the output and renames it to its final name.
  virtual void close() = 0;
  /// Removes everything that was written. Does not throw.
  virtual void discard() noexcept = 0;
};

/// The sink for a path, by its extension. Throws as `MovieWriter`'s constructor does.
std::unique_ptr<ImageSink> imageSink(const std::filesystem::path& file, const MovieOptions& options);

} // namespace viscera::scene
