#include "ffmpeg_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "viscera/core/error.h"
#include "viscera/scene/movie_writer.h"

extern char** environ;

namespace viscera::scene {
namespace {

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
    : movie_(std::move(movie)), messages_(std::tmpfile()) {
  int ends[2];
  if (!messages_ || pipe2(ends, O_CLOEXEC) != 0)
    fail();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages_), STDERR_FILENO);
  std::vector<char*> pointers;
  for (const auto& argument : arguments)
    pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const int result = posix_spawnp(&process_, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  input_ = ends[1];
  if (result != 0) {
    process_ = -1;
    fail();
  }
}

FfmpegProcess::~FfmpegProcess() {
  closeInput();
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (messages_)
    std::fclose(messages_);
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
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    fail();
}

void FfmpegProcess::closeInput() {
  if (input_ >= 0)
    ::close(input_);
  input_ = -1;
}

void FfmpegProcess::fail() {
  std::string said;
  if (messages_) {
    closeInput();
    if (process_ > 0)
      waitpid(std::exchange(process_, -1), nullptr, 0);
    std::rewind(messages_);
    char line[512];
    while (std::fgets(line, sizeof line, messages_))
      said = line;
    while (!said.empty() && std::isspace(static_cast<unsigned char>(said.back())))
      said.pop_back();
  }
  throw CannotCreateError("ffmpeg could not write the movie" + (said.empty() ? "" : ": " + said),
                          movie_.string(), "write an .ogv instead");
}

} // namespace viscera::scene
