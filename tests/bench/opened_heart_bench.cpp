#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include <benchmark/benchmark.h>

#include "build_paths.h"
#include "viscera/coordinates/registry.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/open_files.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/presentation/stage.h"

/// What a frame of the beating sample heart costs, pose and picture, while it is closed, cut open into its
/// tissue, full of blood, and cut as other organs are. To be compared within one run.
namespace viscera {
namespace {

constexpr int kFrameWidth = 1280, kFrameHeight = 800;

enum class Shown { closed, opened, withBlood, cutSurfaces };

/// The heart in the window's size, without a window.
class BeatingPicture {
public:
  explicit BeatingPicture(Shown shown)
      : live_(document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}) {
    undo_.perform(
        document::combined("Show", {document::addOrgans(document::organsFrom(setup_.organ)),
                                    document::replaceRig(setup_.rig), document::setSystem(setup_.system)}));
    view_.cut = {shown != Shown::closed, Vec3::UnitY(), 0, shown == Shown::withBlood};
    if (shown == Shown::opened || shown == Shown::withBlood)
      tissue_ = presentation::heartTissueFor(document_.state(), view_, library(), progress_);
    update();
    stage_.compose(scene::StandardView::anterior);
  }

  void frame() {
    constexpr double kRate = 75, kFramesPerSecond = 30;
    setup_.sequence->poseAt(++frames_ / kFramesPerSecond, kRate, pose_);
    live_.showPose(pose_);
    update();
    const auto picture = stage_.picture();
    benchmark::DoNotOptimize(picture.GetPointer());
  }

private:
  static sample_organs::SampleLibrary library() {
    return {std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
            std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
  }
  void update() {
    presentation::Scene scene{document_.state(), live_, view_, registry_};
    scene.heartTissue = tissue_;
    stage_.presenter().update(scene);
  }

  Progress progress_;
  live::SequenceSetup setup_ =
      live::setUpSequence(library(), "heartbeat", sample_organs::Resolution::medium, progress_);
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](std::function<void()> work) { work(); }};
  live::LiveBinding live_;
  presentation::ViewState view_;
  std::shared_ptr<const live::HeartTissue> tissue_;
  presentation::Stage stage_{kFrameWidth, kFrameHeight, scene::darkTheme()};
  Points pose_;
  int frames_ = 0;
};

void beatingHeart(benchmark::State& state, Shown shown) {
  BeatingPicture picture(shown);
  for (auto _ : state)
    picture.frame();
}
BENCHMARK_CAPTURE(beatingHeart, closed, Shown::closed)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(beatingHeart, opened, Shown::opened)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(beatingHeart, with_blood, Shown::withBlood)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(beatingHeart, cut_surfaces, Shown::cutSurfaces)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace viscera
