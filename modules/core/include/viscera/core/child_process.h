#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include "viscera/core/progress.h"

namespace viscera {

/// The limits of time and memory beyond which a child process is ended.
struct ChildLimits {
  double seconds = 60;
  std::uint64_t memoryBytes = std::uint64_t{2} << 30; ///< Address space of each of its processes.
};

/// How a child process ended: exit code, signal or limit, and its output.
struct ChildResult {
  enum class End {
    exited,
    killed,
    timeLimit,
    notStarted,
    outputLimit ///< It wrote more than its memory limit.
  };
  End end = End::exited;
  int code = 0; ///< Exit code, signal, or the error number of the start.
  std::vector<char> output;
  std::string messages;              ///< The beginning of what it wrote to standard error.
  std::uint64_t peakMemoryBytes = 0; ///< The most that was resident.
};

/// Runs another program in a process group of its own, which the destructor kills and waits for. Belongs to
/// one thread at a time.
class ChildProcess {
public:
  /// Starts `arguments[0]`, looked for in the PATH when it names no folder. It reads from the descriptor
  /// `input` and writes to `output` (below 0: nowhere); the caller keeps both. Throws `Error` when the
  /// machine has no more files.
  ChildProcess(std::vector<std::string> arguments, int input, int output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The error number with which it could not be started, or 0.
  int startError() const { return startError_; }
  /// Limits memory, messages and, for a program that outlives us, processor time; also of the processes that
  /// it starts from now on.
  void limit(const ChildLimits& limits) const;
  /// Whether it has ended; fills in how, but for output and messages. With `wait` it returns only then.
  bool ended(ChildResult& result, bool wait = false);
  /// The beginning of what it has written to standard error, `most` bytes at most.
  std::string messages(std::size_t most) const;

private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, CloseFile> messages_;
  pid_t process_ = -1;
  int startError_ = 0;
  bool ended_ = false;
};

/// Runs `program` (no arguments), with `input` on its standard input, until it ends; collects its standard
/// output. Whatever it does, this returns soon after the time limit, and no process of its group is left. The
/// limits hold before the program gets its input; a process that it has started by then has none of memory.
/// Throws `Cancelled`, after the program was killed; `Error` when the machine has no more files or
/// processes. Thread-safe.
ChildResult runChild(const std::filesystem::path& program, const std::vector<char>& input,
                     const ChildLimits& limits, Progress& progress);

} // namespace viscera
