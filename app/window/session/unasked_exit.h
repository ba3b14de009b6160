#pragma once

#include <functional>

namespace viscera::app {

/// Lets the program do a last thing when a library ends it by `exit`, as Qt, Xlib and Mesa do when the
/// display goes away; none of them has a way back. One at a time, for the thread that the window lives on: an
/// end that another thread asks for is left alone.
///
/// While it lives, `exit` calls `last` (what that throws is dropped) and then ends the program at once with
/// `kExitCode`, without the destructors of a window that has no display.
class UnaskedExit {
public:
  static constexpr int kExitCode = 69; ///< As without a display at the start (sysexits.h, EX_UNAVAILABLE).

  explicit UnaskedExit(std::function<void()> last);
  ~UnaskedExit();
  UnaskedExit(const UnaskedExit&) = delete;
  UnaskedExit& operator=(const UnaskedExit&) = delete;
};

} // namespace viscera::app
