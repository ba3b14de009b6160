#pragma once

#include <functional>
#include <iosfwd>

#include "window_options.h"

/// Runs the program with its command line.
namespace viscera::app::cli {

/// Opens the window and returns the program's exit code.
using OpenWindow = std::function<int(const WindowOptions& options)>;

/// Runs the program `viscera` with its command line: a subcommand, or the window through `openWindow` when
/// none is named. Results go to `out`, everything else to `err`; an error is one line there. Returns the exit
/// code, one of sysexits.h's or 130 after Ctrl+C. Does not throw. Call it once, from the main thread, before
/// other threads are made.
int runCommandLine(int argc, const char* const* argv, std::ostream& out, std::ostream& err,
                   const OpenWindow& openWindow);

} // namespace viscera::app::cli
