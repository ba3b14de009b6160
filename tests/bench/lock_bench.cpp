#include <filesystem>
#include <limits>
#include <memory>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/open_files.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/live/volume_keeper.h"

/// What the first step of a drag waits for under volume locks, without a window.
namespace viscera {
namespace {

/// The sample heart in the handles of its beat, with the volumes of two of its surfaces locked.
class LockedHeart {
public:
  LockedHeart() {
    Progress progress;
    const sample_organs::SampleLibrary library{std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
                                               std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
    const auto setup = live::setUpSequence(library, "heartbeat", sample_organs::Resolution::medium, progress);
    undo_.perform(
        document::combined("Show", {document::addOrgans(document::organsFrom(setup.organ)),
                                    document::replaceRig(setup.rig), document::setSystem(setup.system)}));
    for (std::size_t organ = 0; organ < 2; ++organ)
      undo_.perform(document::setVolumeLocked(document_.organs()[organ]->id, true));
  }

  /// A keeper that has never moved anything; with a queue the one of this heart.
  std::unique_ptr<live::VolumeKeeper> makeKeeper(bool withQueue) {
    return std::make_unique<live::VolumeKeeper>(document_.state(), live_, Threads{},
                                                withQueue ? &jobs_ : nullptr);
  }
  void finishJobs() {
    box_.runUntil([this] { return jobs_.idle(); });
  }
  /// Begins a drag of one handle, moves it and poses the organs.
  void move(live::VolumeKeeper& keeper) {
    live::LockedMotion motion = keeper.begin({document_.rig().handles.front().id});
    undo_.perform(document::setPose(motion.translate({4, 2, 1})));
    for (const auto& organ : document_.organs())
      benchmark::DoNotOptimize(live_.points(organ->id).data());
  }
  void takeBack() { undo_.perform(document::resetPose()); }

private:
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  ManualEventLoop box_;
  JobQueue jobs_{box_.post()};
  live::LiveBinding live_{document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}};
};

/// Where the volume forms come from.
enum class Forms {
  inTheMove,    ///< The move makes them and waits.
  besideIt,     ///< A worker begins with the move, which does without.
  beforeTheMove ///< A worker has made them since the volumes were locked.
};

void firstLockedMove(benchmark::State& state, Forms forms) {
  LockedHeart heart;
  for (auto _ : state) {
    state.PauseTiming();
    auto keeper = heart.makeKeeper(forms != Forms::inTheMove);
    if (forms == Forms::beforeTheMove) {
      keeper->prepare();
      heart.finishJobs();
    }
    state.ResumeTiming();
    heart.move(*keeper);
    state.PauseTiming();
    heart.takeBack();
    keeper.reset(); // Gives up what a worker is at.
    heart.finishJobs();
    state.ResumeTiming();
  }
}
BENCHMARK_CAPTURE(firstLockedMove, made_in_it, Forms::inTheMove)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(10);
BENCHMARK_CAPTURE(firstLockedMove, made_beside_it, Forms::besideIt)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(10);
BENCHMARK_CAPTURE(firstLockedMove, made_before, Forms::beforeTheMove)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(10);

} // namespace
} // namespace viscera
