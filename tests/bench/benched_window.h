#pragma once

#include <chrono>
#include <ctime>
#include <functional>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "window_test.h"

class QApplication;

/// The window as a benchmark drives it. Needs a display, such as Xvfb's.
namespace viscera::bench {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start);

/// What all threads of this program have worked since then, ms.
double processorMs(std::clock_t start);

/// One application for all benchmarks of this program.
QApplication& application();

/// What a benchmark says that needs a file of the shared folder.
inline constexpr const char* kNotShared = "it is not beside the project";

/// The window of the tests, driven by benchmarks.
class BenchedWindow : public tests::WindowTest {
public:
  BenchedWindow();
  ~BenchedWindow() override { TearDown(); }
  void TestBody() override {}
  /// Users have the whole window.
  std::optional<QSize> viewSize() const override { return std::nullopt; }

  using WindowTest::click;
  using WindowTest::document;
  using WindowTest::handleInView;
  using WindowTest::key;
  using WindowTest::now_;
  using WindowTest::onScreen;
  using WindowTest::reachableHandle;
  using WindowTest::settle;
  using WindowTest::view;
  using WindowTest::waitUntil;
  using WindowTest::window;

  /// The sample heart with its motion, which does not play.
  void loadHeart();
  /// A surface that lies beside the project, in thirty handles; false where it is absent.
  bool loadShared(const std::string& file);
  /// Balls in rows of ten, with handles around the first one.
  void addBalls(int organs, int levels);
  /// The same with handles around all, so that all of them follow.
  void addPatient(int organs);
  /// "heart", "liver", "ball_LEVELS" or "organs_NUMBER" as above; false where its file is absent.
  bool load(const std::string& scene);

  /// Handles the events that are there, and draws what waits to be drawn; returns how long that took, s.
  double untilDrawn(const std::function<void()>& event);
  /// Of all threads for one event: other programs lengthen it less than the time until the picture.
  void countWork(benchmark::State& state) const { state.counters["processorMs"] = worked_ / events_; }

private:
  void addBallsAlone(int organs, int levels);
  void addHandles(const Points& places);

  double worked_ = 0;
  int events_ = 0;
};

/// Presses the left button there and moves the mouse about: each step is timed from the event until it is
/// drawn.
void moveTheMouse(benchmark::State& state, BenchedWindow& bench, const QPoint& from);

} // namespace viscera::bench
