#pragma once

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pause_watch.h"
#include "process_use.h"
#include "window/main_window.h"

namespace viscera::tests {

/// One second of a soak.
struct SoakSample {
  double seconds = 0; ///< Since the soak began.
  ProcessUse use;
  int frames = 0;         ///< Drawn in the first view.
  double longestMs = 0;   ///< Between two frames that followed each other while the heart played.
  double pausedMs = 0;    ///< For so long of that the machine itself stood still (PauseWatch).
  std::string occupation; ///< The activity beside the beating: "playing" for none.
};

/// Lets the sample heart beat in a real window in real time, and meanwhile simulates a lesson: drags handles,
/// records movies and compares two rates, over and over. The window is left as it was after each.
class WindowSoak {
public:
  WindowSoak();
  ~WindowSoak();

  /// Runs for so many seconds; `tell` is called with each second as it ends.
  void run(double seconds, const std::function<void(const SoakSample&)>& tell);

private:
  void playFor(double seconds, const char* occupation);
  void drag();
  void compare();
  void record();
  void onFrame();
  void endSecond();
  bool over() const { return static_cast<double>(clock_.elapsed()) / 1000 >= seconds_; }

  QTemporaryDir folder_;
  std::unique_ptr<app::Settings> settings_;
  std::unique_ptr<app::MainWindow> window_;
  QElapsedTimer clock_, sinceFrame_;
  PauseWatch pauses_;
  double seconds_ = 0;
  int rounds_ = 0;
  SoakSample present_;
  std::string occupation_;
  std::function<void(const SoakSample&)> tell_;
};

/// The faults of a soak, a line each; empty when memory, descriptors and threads stayed and no frame came
/// late while nothing went on but the beating. What the machine itself stood still does not count.
std::vector<std::string> soakFaults(const std::vector<SoakSample>& samples);

} // namespace viscera::tests
