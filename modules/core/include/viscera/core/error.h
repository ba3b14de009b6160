#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "viscera/core/phrase.h"

/// The exceptions for errors that a user can do something about. A caller's mistake is an assertion instead.
namespace viscera {

/// The exit code of an internal error after sysexits.h, for failures that neither the caller nor the data has
/// caused.
inline constexpr int kInternalError = 70;

/// The base class of all errors: it holds what went wrong, where (a file, an element), and what to try, and
/// joins the three in its message. `what()` is in English.
class Error : public std::runtime_error {
public:
  /// `exitCode` is the program's, after sysexits.h.
  Error(int exitCode, Text what, Text where = {}, Text tryThis = {});

  const Text& problem() const { return problem_; } ///< Always begins with a capital letter.
  const Text& where() const { return where_; }
  const Text& tryThis() const { return tryThis_; }
  /// All three; `what()` is its English.
  Text explanation() const;
  int exitCode() const { return exitCode_; }

private:
  Text problem_;
  Text where_;
  Text tryThis_;
  int exitCode_;
};

/// Thrown for a command, option or parameter that does not exist or is out of range. Exit code 64.
class UsageError : public Error {
public:
  explicit UsageError(Text what, Text where = {}, Text tryThis = {});
};

/// Thrown for data that can be read but not used: truncated, degenerate, of another kind. Exit code 65.
class DataError : public Error {
public:
  explicit DataError(Text what, Text where = {}, Text tryThis = {});
};

/// Thrown for an input that does not exist or may not be read. Exit code 66.
class NoInputError : public Error {
public:
  explicit NoInputError(Text what, Text where = {}, Text tryThis = {});
};

/// Thrown for an output that cannot be written. Exit code 73.
class CannotCreateError : public Error {
public:
  explicit CannotCreateError(Text what, Text where = {}, Text tryThis = {});
};

/// Thrown out of a long job whose `Progress` was cancelled. Exit code 130, as for Ctrl+C.
class Cancelled : public Error {
public:
  Cancelled();
};

/// The error that replaces an exception of `reportsShortMemory`, with a text for the user; `where` is the
/// file or organ that needs the memory. Its exit code is that of an internal error.
Error notEnoughMemory(Text where = {});

/// Whether an exception says that memory is short: `std::bad_alloc`, `std::length_error` (a size that no
/// container holds), or a `std::system_error` of a system without memory, also for another thread's stack.
/// From any thread.
bool reportsShortMemory(const std::exception& exception) noexcept;

/// What to tell a user of an exception: the explanation of an `Error`, the text of `notEnoughMemory` where
/// that is the reason, else `what()`. From any thread.
Text explanationOf(const std::exception& exception);

/// Calls `work` and returns its result. When memory is too short for it, throws `notEnoughMemory(where)`
/// instead of what `work` has thrown, and everything else unchanged.
template <class Work>
auto explainingShortMemory(const Text& where, Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const std::exception& exception) {
    if (!reportsShortMemory(exception))
      throw;
  }
  throw notEnoughMemory(where); // Here, because what `work` has allocated is free again.
}

} // namespace viscera
