#pragma once

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/// Runs a program as a user's shell would, for tests.
namespace viscera::test {

/// Exit code and output of a process.
struct ProcessResult {
  int exitCode = -1; ///< 128 + n when signal n ended it.
  std::string out;
  std::string err;
};

/// Environment, limits and signals of a process.
struct ProcessOptions {
  std::map<std::string, std::optional<std::string>> environment; ///< Set, or unset where there is no value.
  std::optional<std::chrono::milliseconds> interruptAfter;       ///< Sends `signal` then.
  int signal = SIGINT;                                           ///< Ctrl+C.
  std::optional<std::size_t> addressSpace =
      std::nullopt; ///< The most that it may map, bytes, as `ulimit -v` says it.
  /// The longest file that it may write, bytes; it is told by an error, as on a full disk, not by a signal.
  std::optional<std::size_t> fileSize = std::nullopt;
};

namespace detail {

[[noreturn]] inline void becomeProgram(const std::vector<std::string>& command, const ProcessOptions& options,
                                       int out, int err) {
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  for (const auto& [name, value] : options.environment)
    value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
  if (options.addressSpace) {
    const rlimit limit{*options.addressSpace, *options.addressSpace};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  if (options.fileSize) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{*options.fileSize, *options.fileSize};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execv(arguments[0], arguments.data());
  _exit(127);
}

/// Reads both pipes until the process has closed them.
inline void readAll(int out, int err, ProcessResult& result) {
  std::array<pollfd, 2> sources{pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
  std::array<std::string*, 2> texts{&result.out, &result.err};
  std::array<char, 65536> buffer;
  for (int open = 2; open > 0;) {
    if (::poll(sources.data(), sources.size(), -1) < 0 && errno != EINTR)
      throw std::runtime_error("poll failed");
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (sources[i].fd < 0 || sources[i].revents == 0)
        continue;
      const ssize_t count = ::read(sources[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      } else {
        sources[i].fd = -1;
        --open;
      }
    }
  }
}

} // namespace detail

/// Runs `command` (the program's path first) to its end.
inline ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options = {}) {
  int out[2];
  int err[2];
  if (::pipe2(out, O_CLOEXEC) != 0 || ::pipe2(err, O_CLOEXEC) != 0)
    throw std::runtime_error("pipe failed");
  const pid_t child = ::fork();
  if (child < 0)
    throw std::runtime_error("fork failed");
  if (child == 0)
    detail::becomeProgram(command, options, out[1], err[1]);
  ::close(out[1]);
  ::close(err[1]);
  std::thread interrupter;
  if (options.interruptAfter)
    interrupter = std::thread([child, after = *options.interruptAfter, signal = options.signal] {
      std::this_thread::sleep_for(after);
      ::kill(child, signal);
    });
  ProcessResult result;
  detail::readAll(out[0], err[0], result);
  if (interrupter.joinable())
    interrupter.join(); // Before the wait: until then the number belongs to this child.
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(out[0]);
  ::close(err[0]);
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

} // namespace viscera::test
