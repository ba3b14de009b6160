#include "viscera/core/child_process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

extern char** environ;

namespace viscera {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kLookMs = 20; ///< Interval at which cancellation is checked.
constexpr rlim_t kMostMessages = 1 << 20;
constexpr std::size_t kMessagesKept = 2000;

[[noreturn]] void failed(const Text& what) {
  throw Error(kInternalError, phrase("%1: %2", what, std::string(std::strerror(errno))),
              misuse("child process"));
}

/// A file without a folder, so that a full or read-only /tmp keeps no program from starting; one in /tmp
/// where the system has none. Null: the machine has no more files.
std::FILE* fileForMessages() {
  const int file = memfd_create("messages", MFD_CLOEXEC);
  if (file < 0)
    return std::tmpfile();
  std::FILE* stream = fdopen(file, "r+");
  if (!stream)
    ::close(file);
  return stream;
}

/// A file descriptor that is closed.
class Descriptor {
public:
  explicit Descriptor(int file) : file_(file) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return file_; }
  void close() {
    if (file_ >= 0)
      ::close(file_);
    file_ = -1;
  }

private:
  int file_;
};

/// Both directions of the talk with the program, until it closes its side or `goOn` says no.
class Conversation {
public:
  Conversation(int socket, const std::vector<char>& input, std::vector<char>& output, std::size_t most)
      : socket_(socket), input_(input), output_(output), most_(most) {}

  bool over() const { return over_; }
  bool tooLong() const { return output_.size() > most_; }

  /// Waits a moment for the program and moves what can be moved.
  void step() {
    pollfd state{socket_, static_cast<short>(POLLIN | (sent_ < input_.size() ? POLLOUT : 0)), 0};
    if (poll(&state, 1, kLookMs) <= 0)
      return;
    if (state.revents & POLLOUT)
      send();
    if (state.revents & (POLLIN | POLLHUP | POLLERR))
      receive();
  }

  void finishSending() {
    if (sent_ < input_.size() || closed_)
      return;
    shutdown(socket_, SHUT_WR);
    closed_ = true;
  }

private:
  void send() {
    const ssize_t sent =
        ::send(socket_, input_.data() + sent_, input_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0)
      sent_ += static_cast<std::size_t>(sent);
    else if (errno != EAGAIN && errno != EINTR)
      sent_ = input_.size(); // It no longer listens; what it says is still read.
  }

  void receive() {
    const std::size_t before = output_.size();
    output_.resize(before + kPortion);
    const ssize_t got = recv(socket_, output_.data() + before, kPortion, MSG_DONTWAIT);
    output_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR))
      over_ = true;
  }

  static constexpr std::size_t kPortion = 1 << 20;
  int socket_;
  const std::vector<char>& input_;
  std::vector<char>& output_;
  std::size_t most_;
  std::size_t sent_ = 0;
  bool closed_ = false;
  bool over_ = false;
};

} // namespace

ChildProcess::ChildProcess(std::vector<std::string> arguments, int input, int output)
    : messages_(fileForMessages()) {
  if (!messages_)
    failed(misuse("No file for a program's messages"));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  if (output >= 0)
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages_.get()), STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none); // Ours may be blocked while the program waits for them.
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  std::vector<char*> pointers;
  for (std::string& argument : arguments)
    pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  startError_ = posix_spawnp(&process_, pointers[0], &actions, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (startError_ != 0)
    process_ = -1;
}

ChildProcess::~ChildProcess() {
  if (process_ <= 0)
    return;
  kill(-process_, SIGKILL);
  ChildResult ignored;
  if (!ended_)
    ended(ignored, true);
}

void ChildProcess::limit(const ChildLimits& limits) const {
  const auto set = [this](__rlimit_resource resource, rlim_t most) {
    const rlimit both{most, most};
    prlimit(process_, resource, &both, nullptr); // Fails only for one that has ended already.
  };
  set(RLIMIT_AS, limits.memoryBytes);
  set(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)) + 1);
  set(RLIMIT_CORE, 0);
  set(RLIMIT_FSIZE, kMostMessages);
}

bool ChildProcess::ended(ChildResult& result, bool wait) {
  int status = 0;
  rusage usage{};
  pid_t got = 0;
  while ((got = wait4(process_, &status, wait ? 0 : WNOHANG, &usage)) < 0 && errno == EINTR) {
  }
  if (got != process_)
    return false;
  ended_ = true;
  result.end = WIFEXITED(status) ? ChildResult::End::exited : ChildResult::End::killed;
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status);
  result.peakMemoryBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return true;
}

std::string ChildProcess::messages(std::size_t most) const {
  std::string text(most, '\0');
  const ssize_t got = pread(fileno(messages_.get()), text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return text;
}

ChildResult runChild(const std::filesystem::path& program, const std::vector<char>& input,
                     const ChildLimits& limits, Progress& progress) {
  progress.throwIfCancelled();
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    failed(misuse("No channel to another program"));
  Descriptor ours(ends[0]), theirs(ends[1]);
  ChildResult result;
  const auto begin = Clock::now();
  ChildProcess child({program.string()}, theirs.get(), theirs.get());
  result.code = child.startError();
  theirs.close();
  if (result.code != 0) {
    result.end = ChildResult::End::notStarted;
    return result;
  }
  child.limit(limits);
  Conversation conversation(ours.get(), input, result.output, limits.memoryBytes);
  const auto late = [&] {
    return std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds;
  };
  bool ended = false;
  while (!ended && !late() && !conversation.tooLong()) {
    progress.throwIfCancelled();
    if (!conversation.over()) {
      conversation.finishSending();
      conversation.step();
    } else {
      ended = child.ended(result);
      if (!ended)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  if (!ended)
    result.end = conversation.tooLong() ? ChildResult::End::outputLimit : ChildResult::End::timeLimit;
  result.messages = child.messages(kMessagesKept);
  return result;
}

} // namespace viscera
