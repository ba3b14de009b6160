#pragma once

#include <stdexcept>
#include <string>

/// The exceptions for errors that a user can do something about. A caller's mistake is an assertion instead.
namespace viscera {

/// The exit code of an internal error after sysexits.h, for failures that neither the caller nor the data has
/// caused.
inline constexpr int kInternalError = 70;

/// The base class of all errors: it holds what went wrong, where (a file, an element), and what to try, and
/// joins the three in its message.
class Error : public std::runtime_error {
public:
  /// `exitCode` is the program's, after sysexits.h.
  Error(int exitCode, std::string what, std::string where = {}, std::string tryThis = {});

  const std::string& problem() const { return problem_; } ///< Always begins with a capital letter.
  const std::string& where() const { return where_; }
  const std::string& tryThis() const { return tryThis_; }
  int exitCode() const { return exitCode_; }

private:
  std::string problem_;
  std::string where_;
  std::string tryThis_;
  int exitCode_;
};

/// Thrown for a command, option or parameter that does not exist or is out of range. Exit code 64.
class UsageError : public Error {
public:
  explicit UsageError(std::string what, std::string where = {}, std::string tryThis = {});
};

/// Thrown for data that can be read but not used: truncated, degenerate, of another kind. Exit code 65.
class DataError : public Error {
public:
  explicit DataError(std::string what, std::string where = {}, std::string tryThis = {});
};

/// Thrown for an input that does not exist or may not be read. Exit code 66.
class NoInputError : public Error {
public:
  explicit NoInputError(std::string what, std::string where = {}, std::string tryThis = {});
};

/// Thrown for an output that cannot be written. Exit code 73.
class CannotCreateError : public Error {
public:
  explicit CannotCreateError(std::string what, std::string where = {}, std::string tryThis = {});
};

/// Thrown out of a long job whose `Progress` was cancelled. Exit code 130, as for Ctrl+C.
class Cancelled : public Error {
public:
  Cancelled();
};

/// The error that replaces `std::bad_alloc`, with a text for the user. Its exit code is that of an internal
/// error.
Error notEnoughMemory();

} // namespace viscera
