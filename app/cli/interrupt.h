#pragma once

#include <thread>

#include "viscera/core/progress.h"

namespace viscera::app::cli {

/// Lets Ctrl+C (SIGINT), SIGTERM and SIGHUP cancel `progress` instead of ending the program, as long as the
/// object lives, so that the job can clean up. The second signal ends the program at once.
///
/// A thread of its own waits for the signals; so nothing runs inside a signal handler, and nothing is global.
/// Make it before any other thread: threads inherit which signals they do not take.
class Interrupt {
public:
  explicit Interrupt(Progress& progress);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

private:
  void wait(Progress& progress) const;

  int signals_ = -1; ///< Readable when a signal has come.
  int stop_ = -1;    ///< Readable when the thread is to end.
  std::thread thread_;
};

} // namespace viscera::app::cli
