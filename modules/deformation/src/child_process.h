#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "viscera/core/progress.h"

namespace viscera::deformation {

/// What a program may take before it is ended.
struct ChildLimits {
  double seconds = 60;
  std::uint64_t memoryBytes = std::uint64_t{2} << 30; ///< Address space of each of its processes.
};

/// How a program ended.
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

/// Runs `program` (no arguments), with `input` on its standard input, until it ends; collects its standard
/// output. Whatever it does, this returns soon after the time limit, and no process of its group is left.
/// Throws `Cancelled`, after the program was killed; `Error` when the machine has no more files or
/// processes. Thread-safe.
ChildResult runChild(const std::filesystem::path& program, const std::vector<char>& input,
                     const ChildLimits& limits, Progress& progress);

} // namespace viscera::deformation
