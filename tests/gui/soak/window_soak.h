#pragma once

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <string>

#include "machine_watch.h"
#include "soak_faults.h"
#include "window/main_window.h"

namespace viscera::tests {

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
  void rest();
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
  MachineWatch machine_;
  double seconds_ = 0;
  int rounds_ = 0;
  SoakSample present_;
  std::string occupation_;
  std::function<void(const SoakSample&)> tell_;
};

} // namespace viscera::tests
