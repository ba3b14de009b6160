#pragma once

#include <exception>
#include <functional>
#include <iosfwd>
#include <string>

#include "viscera/core/error.h"

namespace viscera::app::cli {

/// An error as the program tells it: a line on stderr for a reader, and with `--json` an object on stdout.
struct Failure {
  std::string what;    ///< What is wrong.
  std::string where;   ///< The file, the option or the element; empty: none.
  std::string tryThis; ///< What to try; empty: nothing is known.
  std::string line;    ///< All of it in one line.
  int exitCode = kInternalError;
};

/// The failure that an exception means: an `Error` with its parts, too little memory, or an internal error.
/// `told` puts the names that the user gave into each text.
Failure failureOf(const std::exception& exception,
                  const std::function<std::string(std::string)>& told = nullptr);

/// Prints the line "viscera: ..." to `err` and, when `json`, the object {"error": {"what", "where", "try"},
/// "exitCode"} to `out`. Returns the exit code.
int printFailure(const Failure& failure, bool json, std::ostream& out, std::ostream& err);

/// One line for a terminal, whatever the message holds.
std::string oneLine(std::string text);

} // namespace viscera::app::cli
