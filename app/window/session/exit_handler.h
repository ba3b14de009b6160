#pragma once

#include <functional>

namespace viscera::app {

/// Calls a function when a library ends the program by `exit`, as Qt, Xlib and Mesa do when the connection to
/// the display is lost; none of them allows to prevent that. Only one object at a time, on the thread of the
/// window: calls of `exit` on another thread are not affected.
///
/// While it lives, `exit` calls `last` (what that throws is dropped) and then ends the program at once with
/// `kExitCode`, without the destructors of a window that has no display.
class ExitHandler {
public:
  static constexpr int kExitCode = 69; ///< As without a display at the start (sysexits.h, EX_UNAVAILABLE).

  explicit ExitHandler(std::function<void()> last);
  ~ExitHandler();
  ExitHandler(const ExitHandler&) = delete;
  ExitHandler& operator=(const ExitHandler&) = delete;
};

} // namespace viscera::app
