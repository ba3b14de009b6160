#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "viscera/coordinates/registry.h"
#include "viscera/document/open_files.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/scene/organ_actor.h"
#include "viscera/scene/volume_chart.h"
#include "viscera/sequences/volume_record.h"

/// What a frame of the window costs while an organ moves, but for drawing it.
namespace viscera {
namespace {

constexpr double kFrameSeconds = 1.0 / 30;
constexpr std::size_t kFramesAChart = 3; ///< The chart follows at 10 Hz.

/// The window's document, binding, surfaces, record and chart, without a window.
class PlayedOrgan {
public:
  PlayedOrgan(const char* sequence, double rate)
      : rate_(rate), live_(document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}) {
    Progress progress;
    const sample_organs::SampleLibrary library{std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
                                               std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
    const auto setup = live::setUpSequence(library, sequence, sample_organs::Resolution::medium, progress);
    sequence_ = setup.sequence;
    undo_.perform(
        document::combined("Show", {document::addOrgans(document::organsFrom(setup.organ)),
                                    document::replaceRig(setup.rig), document::setSystem(setup.system)}));
    std::vector<std::string> names;
    std::vector<scene::ChartLine> lines;
    for (const auto& organ : document_.organs()) {
      actors_.push_back(std::make_unique<scene::OrganActor>(organ->mesh));
      actors_.back()->setPoints({std::shared_ptr<void>(), &live_.points(organ->id)});
      names.push_back(organ->name);
      lines.push_back({organ->name, organ->look.color});
    }
    record_ = sequences::VolumeRecord(names, 7200);
    measure();
    chart_.setLines(lines);
    chart_.setTimeRange({0, 60 / rate});
  }

  /// The whole cycle, as a worker of the window measures it.
  void measure() {
    live::PosedCopy organs = live_.copy();
    live::MotionRunner runner(document_.state(), organs);
    runner.setSequence(sequence_);
    runner.setRatePerMinute(rate_);
    Progress progress;
    cycle_ = live::measureCycle(runner, progress);
  }
  void lock() { undo_.perform(document::setVolumeLocked(document_.organs().front()->id, true)); }
  void pose() { sequence_->poseAt(seconds_, rate_, pose_); }
  void positions() { live_.showPose(pose_); }
  void normals() {
    for (const auto& actor : actors_)
      actor->pointsChanged();
  }
  void volumes() {
    row_.clear();
    for (const auto& organ : document_.organs())
      row_.push_back(live_.volume(organ->id).nowMl);
  }
  void chartData() {
    record_.add(seconds_, row_);
    const double cycles = seconds_ * rate_ / 60;
    if (++frames_ % kFramesAChart != 0)
      return;
    for (std::size_t line = 0; line < row_.size(); ++line)
      chart_.setCurve(static_cast<int>(line), cycle_.fractions, cycle_.milliliters[line]);
    chart_.setCursor(cycles - std::floor(cycles));
    chart_.update();
  }
  void next() { seconds_ += kFrameSeconds; }
  double vertices() const {
    double count = 0;
    for (const auto& organ : document_.organs())
      count += static_cast<double>(organ->mesh->points.rows());
    return count;
  }
  double handles() const { return static_cast<double>(sequence_->restHandles().rows()); }

private:
  double rate_;
  std::shared_ptr<const sequences::Sequence> sequence_;
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](std::function<void()> work) { work(); }};
  live::LiveBinding live_;
  std::vector<std::unique_ptr<scene::OrganActor>> actors_;
  sequences::VolumeRecord record_;
  live::CycleCurves cycle_;
  scene::VolumeChart chart_;
  Points pose_;
  std::vector<double> row_;
  double seconds_ = 0;
  std::size_t frames_ = 0;
};

/// A whole frame: pose, positions, normals, volumes, chart data.
void frameButDrawing(benchmark::State& state, const char* sequence, double rate) {
  PlayedOrgan organ(sequence, rate);
  for (auto _ : state) {
    organ.pose();
    organ.positions();
    organ.normals();
    organ.volumes();
    organ.chartData();
    organ.next();
  }
  state.counters["vertices"] = organ.vertices();
  state.counters["handles"] = organ.handles();
}
BENCHMARK_CAPTURE(frameButDrawing, heartbeat, "heartbeat", 75)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frameButDrawing, peristalsis, "peristalsis", 3)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// With the volume of the first organ kept (1) or free (0).
void wholeCycleAhead(benchmark::State& state, const char* sequence, double rate) {
  PlayedOrgan organ(sequence, rate);
  if (state.range(0) != 0)
    organ.lock();
  for (auto _ : state)
    organ.measure();
}
BENCHMARK_CAPTURE(wholeCycleAhead, heartbeat, "heartbeat", 75)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("locked")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(wholeCycleAhead, peristalsis, "peristalsis", 3)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("locked")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// One part of it, with all that it needs of the others done outside the time.
void partOfFrame(benchmark::State& state, void (PlayedOrgan::*part)()) {
  PlayedOrgan organ("heartbeat", 75);
  const auto each = {&PlayedOrgan::pose, &PlayedOrgan::positions, &PlayedOrgan::normals,
                     &PlayedOrgan::volumes, &PlayedOrgan::chartData};
  for (auto _ : state) {
    for (const auto step : each) {
      if (step != part)
        state.PauseTiming();
      (organ.*step)();
      if (step != part)
        state.ResumeTiming();
    }
    organ.next();
  }
}
BENCHMARK_CAPTURE(partOfFrame, pose, &PlayedOrgan::pose)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(partOfFrame, positions, &PlayedOrgan::positions)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(partOfFrame, normals, &PlayedOrgan::normals)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(partOfFrame, volumes, &PlayedOrgan::volumes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(partOfFrame, chartData, &PlayedOrgan::chartData)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace viscera
