#include "ffmpeg_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "viscera/core/error.h"
#include "viscera/scene/movie_writer.h"

namespace viscera::scene {
namespace {

constexpr std::size_t kMostMessages = 1 << 16; ///< Bytes.

/// While it lives, writing to a closed pipe is an error of `write` instead of the end of the program.
class BrokenPipeBlocked {
public:
  BrokenPipeBlocked() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~BrokenPipeBlocked() {
    if (!sigismember(&before_, SIGPIPE)) { // Take back one that may be waiting.
      const timespec now{0, 0};
      while (sigtimedwait(&pipe_, nullptr, &now) > 0) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

private:
  sigset_t pipe_;
  sigset_t before_;
};

} // namespace

bool ffmpegInstalled() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/ffmpeg").c_str(), X_OK) == 0)
      return true;
  return false;
}

FfmpegProcess::FfmpegProcess(const std::vector<std::string>& arguments, std::filesystem::path movie)
    : movie_(std::move(movie)) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    fail();
  process_.emplace(arguments, ends[0], -1);
  ::close(ends[0]);
  input_ = ends[1];
  if (process_->startError() != 0)
    fail();
}

FfmpegProcess::~FfmpegProcess() {
  closeInput();
}

void FfmpegProcess::write(const void* data, std::size_t size) {
  const BrokenPipeBlocked blocked;
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(input_, bytes, size);
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      fail();
    bytes += written;
    size -= std::size_t(written);
  }
}

void FfmpegProcess::finish() {
  closeInput();
  ChildResult result;
  process_->ended(result, true);
  if (result.end != ChildResult::End::exited || result.code != 0)
    fail();
}

void FfmpegProcess::closeInput() {
  if (input_ >= 0)
    ::close(input_);
  input_ = -1;
}

void FfmpegProcess::fail() {
  closeInput();
  std::string said;
  if (process_ && process_->startError() == 0) {
    ChildResult ignored;
    process_->ended(ignored, true);
    std::istringstream lines(process_->messages(kMostMessages));
    for (std::string line; std::getline(lines, line);) // The last line says why.
      said = line.find_first_not_of(" \t\r") == std::string::npos ? said : line;
  }
  throw CannotCreateError("The program ffmpeg could not write the movie" + (said.empty() ? "" : ": " + said),
                          movie_.string(), "write an .ogv instead");
}

} // namespace viscera::scene
