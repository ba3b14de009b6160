#include <QTest>

#include <benchmark/benchmark.h>

#include "benched_window.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"

/// What a step of the work in the window takes until it is drawn, by what is open: undo and redo, another
/// mode, turning the view, another opacity. The scenes are those of `BenchedWindow::load`; the argument
/// "mode" is the key of the mode.
namespace viscera::bench {
namespace {

enum class Step { undo, redo };

Qt::KeyboardModifiers modifiersOf(Step step) {
  return step == Step::undo ? Qt::KeyboardModifiers(Qt::ControlModifier)
                            : Qt::ControlModifier | Qt::ShiftModifier;
}

Qt::Key keyOfMode(const benchmark::State& state) {
  return static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>(state.range(0)));
}

/// A pose of all handles is taken back, or done again, until the organ is drawn in the other one.
void stepOfAPose(benchmark::State& state, const char* scene, Step step) {
  BenchedWindow bench;
  if (!bench.load(scene))
    return state.SkipWithError(kNotShared);
  bench.key(keyOfMode(state));
  const Points pose = 1.05 * bench.document().rig().restPositions();
  for (auto _ : state) {
    bench.window().workspace().perform(document::setPose(pose));
    bench.settle();
    if (step == Step::redo)
      bench.key(Qt::Key_Z, modifiersOf(Step::undo));
    state.SetIterationTime(
        bench.untilDrawn([&] { QTest::keyClick(&bench.window(), Qt::Key_Z, modifiersOf(step)); }));
    bench.settle();
    if (step == Step::redo)
      bench.key(Qt::Key_Z, modifiersOf(Step::undo));
  }
  bench.countWork(state);
}

void undoAPose(benchmark::State& state, const char* scene) {
  stepOfAPose(state, scene, Step::undo);
}
void redoAPose(benchmark::State& state, const char* scene) {
  stepOfAPose(state, scene, Step::redo);
}

/// From Explore, or from Deform into Explore.
void changeTheMode(benchmark::State& state, const char* scene) {
  BenchedWindow bench;
  if (!bench.load(scene))
    return state.SkipWithError(kNotShared);
  const Qt::Key wanted = keyOfMode(state);
  const Qt::Key before = wanted == Qt::Key_1 ? Qt::Key_3 : Qt::Key_1;
  for (auto _ : state) {
    bench.key(before);
    state.SetIterationTime(bench.untilDrawn([&] { QTest::keyClick(&bench.window(), wanted); }));
    bench.settle();
  }
  bench.countWork(state);
}

void inAllModes(benchmark::internal::Benchmark* benchmark) {
  benchmark->DenseRange(1, 5)->ArgName("mode")->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(8);
}
/// One is enough where the number of vertices or organs is what is asked about.
void inDeform(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(3)->ArgName("mode")->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(10);
}

BENCHMARK_CAPTURE(undoAPose, heart, "heart")->Apply(inAllModes);
BENCHMARK_CAPTURE(undoAPose, liver, "liver")->Apply(inAllModes);
BENCHMARK_CAPTURE(undoAPose, ball_6, "ball_6")->Apply(inDeform);
BENCHMARK_CAPTURE(undoAPose, ball_8, "ball_8")->Apply(inDeform);
BENCHMARK_CAPTURE(undoAPose, organs_3, "organs_3")->Apply(inDeform);
BENCHMARK_CAPTURE(undoAPose, organs_95, "organs_95")->Apply(inDeform);

BENCHMARK_CAPTURE(redoAPose, heart, "heart")->Apply(inAllModes);
BENCHMARK_CAPTURE(redoAPose, liver, "liver")->Apply(inAllModes);
BENCHMARK_CAPTURE(redoAPose, ball_6, "ball_6")->Apply(inDeform);
BENCHMARK_CAPTURE(redoAPose, ball_8, "ball_8")->Apply(inDeform);

BENCHMARK_CAPTURE(changeTheMode, heart, "heart")->Apply(inAllModes);
BENCHMARK_CAPTURE(changeTheMode, liver, "liver")->Apply(inAllModes);
BENCHMARK_CAPTURE(changeTheMode, ball_6, "ball_6")->Apply(inDeform);
BENCHMARK_CAPTURE(changeTheMode, ball_8, "ball_8")->Apply(inDeform);
BENCHMARK_CAPTURE(changeTheMode, organs_3, "organs_3")->Apply(inDeform);
BENCHMARK_CAPTURE(changeTheMode, organs_95, "organs_95")->Apply(inDeform);

/// A step of the mouse that turns the camera in Explore, with the shortcuts of what moves (1) or without (0).
void turnTheView(benchmark::State& state, const char* scene) {
  BenchedWindow bench;
  if (!bench.load(scene))
    return state.SkipWithError(kNotShared);
  bench.key(Qt::Key_1);
  const bool all = state.range(0) != 0;
  bench.view().view().setShortcuts({.fewerTriangles = all, .blending = all});
  moveTheMouse(state, bench, bench.view().rect().center());
}

void withAndWithoutShortcuts(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1)
      ->Arg(0)
      ->ArgName("shortcuts")
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(40);
}
void withShortcuts(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1)->ArgName("shortcuts")->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(40);
}

BENCHMARK_CAPTURE(turnTheView, heart, "heart")->Apply(withAndWithoutShortcuts);
// It is small and opaque: they change nothing.
BENCHMARK_CAPTURE(turnTheView, liver, "liver")->Apply(withShortcuts);
BENCHMARK_CAPTURE(turnTheView, ball_8, "ball_8")->Apply(withAndWithoutShortcuts);
BENCHMARK_CAPTURE(turnTheView, ball_9, "ball_9")->Apply(withAndWithoutShortcuts);
BENCHMARK_CAPTURE(turnTheView, organs_95, "organs_95")->Apply(withAndWithoutShortcuts);

/// One organ of several gets another opacity, as the slider gives it.
void fadeAnOrgan(benchmark::State& state) {
  BenchedWindow bench;
  bench.addPatient(static_cast<int>(state.range(0)));
  const document::OrganId organ = bench.document().organs().front()->id;
  for (auto _ : state) {
    document::OrganLook look = bench.document().organ(organ)->look;
    look.opacity = look.opacity < 0.45 ? 0.5 : 0.4;
    state.SetIterationTime(
        bench.untilDrawn([&] { bench.window().workspace().perform(document::setOrganLook(organ, look)); }));
    bench.settle();
  }
  bench.countWork(state);
}
BENCHMARK(fadeAnOrgan)
    ->Arg(3)
    ->Arg(95)
    ->ArgName("organs")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(10);

} // namespace
} // namespace viscera::bench
