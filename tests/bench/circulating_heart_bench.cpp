#include <filesystem>
#include <limits>
#include <memory>

#include <benchmark/benchmark.h>
#include <vtkRenderWindow.h>

#include "build_paths.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/coordinates/registry.h"
#include "viscera/document/open_files.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/live_binding.h"
#include "viscera/presentation/circulation_figure.h"
#include "viscera/scene/surfaceless_window.h"

/// What a control of the circulation costs while it moves, until loop, curves and heart show it: the window
/// promises 100 ms. The window does the heart beside the charts; here they are done one after the other.
namespace viscera {
namespace {

constexpr int kWidth = 860, kHeight = 280; ///< Of the charts, in a window of 1280 x 800.

/// The window's circulation, charts and heart, without a window.
class MovedControl {
public:
  MovedControl()
      : live_(document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}),
        heart_(library(), sample_organs::Resolution::medium, progress_) {
    panels_.setWindow(window_.window());
    solve();
    follow();
    undo_.perform(
        document::combined("Show", {document::addOrgans(document::organsFrom(heart_.organ())),
                                    document::replaceRig(document::rigOf(*sequence_)),
                                    document::setSystem(heart_.setup(course(), progress_).system)}));
  }

  void move() {
    shown_.parameters.systemic.resistance *= 1 + 0.02 * direction_;
    if (shown_.parameters.systemic.resistance > 1.5 || shown_.parameters.systemic.resistance < 0.7)
      direction_ = -direction_;
  }
  void solve() {
    circulation::PeriodicState found =
        circulation::findPeriodicState(shown_.parameters, progress_, {}, known_ ? &start_ : nullptr);
    shown_.indices = circulation::indicesOf(shown_.parameters, found.beat);
    shown_.beat = std::move(found.beat);
    start_ = found.start;
    known_ = true;
  }
  void follow() { sequence_ = heart_.follow(course(), progress_); }
  void charts() {
    panels_.setPanels(presentation::circulationStrip(shown_, &shown_, {.width = kWidth, .height = kHeight}));
    panels_.update();
    window_.window()->Render();
  }
  void pose() {
    sequence_->poseAt(0.2, sequence_->standardRatePerMinute(), pose_);
    live_.showPose(pose_);
    for (const auto& organ : document_.organs())
      benchmark::DoNotOptimize(live_.volume(organ->id).nowMl);
  }

private:
  static sample_organs::SampleLibrary library() {
    return {std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
            std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
  }
  heart::HeartCourse course() const {
    return live::heartCourse("Heartbeat", shown_.parameters, shown_.beat, shown_.indices);
  }

  Progress progress_;
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](std::function<void()> work) { work(); }};
  live::LiveBinding live_;
  live::CirculatingHeart heart_;
  scene::SurfacelessWindow window_{kWidth, kHeight};
  scene::CurvePanels panels_;
  presentation::ShownCirculation shown_;
  circulation::State start_{};
  bool known_ = false;
  double direction_ = 1;
  std::shared_ptr<const sequences::Sequence> sequence_;
  Points pose_;
};

void movedControl(benchmark::State& state) {
  MovedControl control;
  for (auto _ : state) {
    control.move();
    control.solve();
    control.charts();
    control.follow();
    control.pose();
  }
}
BENCHMARK(movedControl)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One part of it.
void partOfMovedControl(benchmark::State& state, void (MovedControl::*part)()) {
  MovedControl control;
  for (auto _ : state) {
    state.PauseTiming();
    control.move();
    control.solve();
    state.ResumeTiming();
    (control.*part)();
  }
}
BENCHMARK_CAPTURE(partOfMovedControl, charts, &MovedControl::charts)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(partOfMovedControl, follow, &MovedControl::follow)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(partOfMovedControl, pose, &MovedControl::pose)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace viscera
