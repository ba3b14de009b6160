#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/child_process.h"

namespace viscera::scene {

/// A running ffmpeg that is fed through a pipe. What it says goes into the error when it fails.
class FfmpegProcess {
public:
  /// Starts it. `movie` is named in errors. Throws `CannotCreateError`.
  FfmpegProcess(const std::vector<std::string>& arguments, std::filesystem::path movie);
  /// Kills it when it was not finished.
  ~FfmpegProcess();
  FfmpegProcess(const FfmpegProcess&) = delete;
  FfmpegProcess& operator=(const FfmpegProcess&) = delete;

  /// Throws `CannotCreateError` when it has gone.
  void write(const void* data, std::size_t size);
  /// Closes its input and waits. Throws `CannotCreateError` when it failed.
  void finish();

private:
  [[noreturn]] void fail();
  void closeInput();

  std::filesystem::path movie_;
  std::optional<ChildProcess> process_;
  int input_ = -1;
};

} // namespace viscera::scene
