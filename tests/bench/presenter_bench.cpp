#include <cmath>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "session_fixture.h"
#include "viscera/coordinates/registry.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/presentation/presenter.h"

/// What an event of the window costs until the picture can be drawn: a handle that is dragged, a look that
/// changes, and an event that changes nothing, with one organ and with many.
namespace viscera {
namespace {

/// Balls in rows, all bound to the same 60 handles, and a presenter that shows them. Nothing is rendered.
class ShownBalls {
public:
  ShownBalls(int organs, int levels)
      : live_(document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}) {
    std::vector<document::NewOrgan> balls;
    Points all(0, 3);
    for (int i = 0; i < organs; ++i) {
      const Vec3 place(70.0 * (i % 10), 70.0 * (i / 10), 0);
      balls.push_back(tests::ball("Ball " + std::to_string(i), 30, levels, place));
      const Points& points = balls.back().organ.mesh->points;
      all.conservativeResize(all.rows() + points.rows(), 3);
      all.bottomRows(points.rows()) = points;
    }
    undo_.perform(document::addOrgans(std::move(balls)));
    const Points box = deformation::enclosingHandles(all);
    std::vector<document::NewHandle> handles;
    for (Eigen::Index row = 0; row < box.rows(); ++row)
      handles.push_back({box.row(row).transpose()});
    const auto spread = static_cast<Eigen::Index>(60 - handles.size());
    for (Eigen::Index i = 0; i < spread; ++i)
      handles.push_back({all.row(i * (all.rows() / spread)).transpose() * 1.0001});
    undo_.perform(document::addHandles(handles));
    dragged_ = document_.rig().handles.back().id;
    update();
  }

  void update() { presenter_.update({document_.state(), live_, look_, registry_}); }
  void drag() {
    const Points& pose = document_.pose();
    Points next = pose.bottomRows(1);
    next(0, 2) += std::sin(++steps_);
    undo_.perform(document::moveHandles({dragged_}, next));
  }
  void fade() {
    document::OrganLook look = document_.organs().front()->look;
    look.opacity = look.opacity < 1 ? 1 : 0.5;
    undo_.perform(document::setOrganLook(document_.organs().front()->id, look));
  }

private:
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](std::function<void()> work) { work(); }};
  live::LiveBinding live_;
  presentation::ViewState look_;
  scene::OrganView view_;
  presentation::Presenter presenter_{view_};
  document::HandleId dragged_;
  int steps_ = 0;
};

/// One step of a drag: command, derived positions and volumes, and the picture's actors.
void dragStep(benchmark::State& state, int organs, int levels) {
  ShownBalls balls(organs, levels);
  for (auto _ : state) {
    balls.drag();
    balls.update();
  }
}
BENCHMARK_CAPTURE(dragStep, one_organ_of_10242, 1, 5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(dragStep, organs_95_of_2562, 95, 4)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The presenter's part of it.
void updateAfterDrag(benchmark::State& state, int organs, int levels) {
  ShownBalls balls(organs, levels);
  for (auto _ : state) {
    state.PauseTiming();
    balls.drag();
    state.ResumeTiming();
    balls.update();
  }
}
BENCHMARK_CAPTURE(updateAfterDrag, one_organ_of_10242, 1, 5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(updateAfterDrag, organs_95_of_2562, 95, 4)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The look of one organ of many changes.
void updateAfterLook(benchmark::State& state, int organs) {
  ShownBalls balls(organs, 4);
  for (auto _ : state) {
    balls.fade();
    balls.update();
  }
}
BENCHMARK_CAPTURE(updateAfterLook, organs_1, 1)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(updateAfterLook, organs_95, 95)->Unit(benchmark::kMicrosecond)->UseRealTime();

/// An event after which nothing is different.
void updateOfNothing(benchmark::State& state, int organs) {
  ShownBalls balls(organs, 4);
  for (auto _ : state)
    balls.update();
}
BENCHMARK_CAPTURE(updateOfNothing, organs_1, 1)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK_CAPTURE(updateOfNothing, organs_95, 95)->Unit(benchmark::kMicrosecond)->UseRealTime();

} // namespace
} // namespace viscera
