#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QImage>
#include <QProcess>
#include <QScreen>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <ctime>
#include <filesystem>
#include <functional>
#include <string>

#include <benchmark/benchmark.h>
#include <vtkRenderWindow.h>

#include "atlas_window.h"
#include "benched_window.h"
#include "build_paths.h"
#include "viscera/document/organ_commands.h"
#include "viscera/heart/course_heartbeat.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/strain/strain_model.h"
#include "window/stress/stress_mode.h"
#include "window/stress/stress_model.h"

/// What a hand on the window waits for: from the event until the picture is drawn. Needs a display, such as
/// Xvfb's.
namespace viscera::bench {
namespace {

/// For preparing the layers of a heart's wall, once.
constexpr int kMeasuredPatienceMs = 300'000;

/// From making the window, as the program does at its start, until the beating heart is drawn. Without the
/// cache the organ is made first; what the system needs to load the program comes on top.
void firstPicture(benchmark::State& state) {
  application();
  const bool cached = state.range(0) != 0;
  const QByteArray cache = qgetenv("XDG_CACHE_HOME");
  if (cached) {
    BenchedWindow before; // Fills the cache of the organs.
    before.loadHeart();
  }
  double chart = 0;
  for (auto _ : state) {
    const QTemporaryDir empty;
    if (!cached)
      qputenv("XDG_CACHE_HOME", empty.path().toLocal8Bit());
    const auto start = Clock::now();
    app::Settings settings{QString()};
    app::MainWindow window(settings, coordinates::builtInRegistry(), live::Player::steadyClock());
    window.resize(1440, 900);
    window.setMode("play");
    window.samples().load(QStringLiteral("heart"), true);
    window.show();
    app::ViewWidget& view = *window.viewArea().view();
    while (view.view().organs().empty() || !window.playback().player().playing())
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    view.scheduleRender();
    view.renderPending();
    view.renderWindow()->WaitForCompletion();
    state.SetIterationTime(secondsSince(start));
    while (!window.volumes().indices(1))
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    chart += secondsSince(start);
    qputenv("XDG_CACHE_HOME", cache);
    window.sessions().setQuestion([](const QString&) { return app::SessionFiles::Answer::discard; });
    window.close();
  }
  state.counters["chartMs"] = benchmark::Counter(1e3 * chart, benchmark::Counter::kAvgIterations);
}
BENCHMARK(firstPicture)->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(5);

/// Sees when a widget has painted itself.
class PaintWatch final : public QObject {
public:
  explicit PaintWatch(QWidget& watched) { watched.installEventFilter(this); }
  bool painted() const { return painted_; }

protected:
  bool eventFilter(QObject*, QEvent* event) override {
    painted_ = painted_ || event->type() == QEvent::Paint;
    return false;
  }

private:
  bool painted_ = false;
};

/// From making the window until a heart is first seen in it: the picture that stands in for the organ while a
/// worker makes it, or the organ itself where that is there sooner. Wanted: half a second. Counter `opaque`:
/// the part of the picture's middle third that nothing shines through.
void firstSight(benchmark::State& state) {
  application();
  const bool cached = state.range(0) != 0;
  const QByteArray cache = qgetenv("XDG_CACHE_HOME");
  if (cached) {
    BenchedWindow before; // Fills the cache of the organs.
    before.loadHeart();
  }
  for (auto _ : state) {
    const QTemporaryDir empty;
    if (!cached)
      qputenv("XDG_CACHE_HOME", empty.path().toLocal8Bit());
    const auto start = Clock::now();
    app::Settings settings{QString()};
    app::MainWindow window(settings, coordinates::builtInRegistry(), live::Player::steadyClock());
    window.resize(1440, 900);
    window.setMode("play");
    const PaintWatch picture(*window.findChild<QWidget*>(QStringLiteral("firstPicture")));
    window.samples().load(QStringLiteral("heart"), true);
    window.show();
    app::ViewWidget& view = *window.viewArea().view();
    while (!picture.painted() && view.view().organs().empty())
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    if (!picture.painted()) {
      view.scheduleRender();
      view.renderPending();
      view.renderWindow()->WaitForCompletion();
    }
    state.SetIterationTime(secondsSince(start));
    qputenv("XDG_CACHE_HOME", cache);
    window.sessions().setQuestion([](const QString&) { return app::SessionFiles::Answer::discard; });
    window.close();
  }
  const QImage shown(QStringLiteral(":/viscera/pictures/sample_heart.png"));
  int all = 0, opaque = 0;
  for (int y = shown.height() / 3; y < 2 * shown.height() / 3; ++y)
    for (int x = shown.width() / 3; x < 2 * shown.width() / 3; ++x, ++all)
      opaque += shown.pixelColor(x, y).alpha() == 255 ? 1 : 0;
  state.counters["opaque"] = all > 0 ? double(opaque) / all : 0;
}
BENCHMARK(firstSight)
    ->Arg(1)
    ->Arg(0)
    ->ArgName("cached")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(5);

/// Whether something of the colour of a heart is in the middle of the screen.
bool heartIsOnTheScreen() {
  QScreen* screen = QGuiApplication::primaryScreen();
  const QPoint middle = screen->geometry().center();
  const QImage image = screen->grabWindow(0, middle.x() - 150, middle.y() - 150, 300, 300).toImage();
  int red = 0;
  for (int y = 0; y < image.height(); y += 4)
    for (int x = 0; x < image.width(); x += 4) {
      const QColor color = image.pixelColor(x, y);
      red += color.red() > color.green() + 40 && color.red() > color.blue() + 40 ? 1 : 0;
    }
  return red > 200;
}

/// From the start of the program, as a shell starts it, until the heart is seen on the screen; its organs are
/// in the cache (1) or not (0). The screen is looked at every few milliseconds.
void startTheProgram(benchmark::State& state) {
  application();
  const bool cached = state.range(0) != 0;
  if (cached) {
    BenchedWindow before; // Fills the cache of the organs.
    before.loadHeart();
  }
  for (auto _ : state) {
    const QTemporaryDir empty;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), empty.path());
    if (!cached) {
      environment.insert(QStringLiteral("XDG_CACHE_HOME"), empty.path());
      // Mesa's compiled shaders are no organs.
      environment.insert(QStringLiteral("MESA_SHADER_CACHE_DIR"),
                         QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation));
    }
    QProcess program;
    program.setProcessEnvironment(environment);
    const auto start = Clock::now();
    program.start(QStringLiteral(VISCERA_PROGRAM), QStringList());
    while (!heartIsOnTheScreen() && secondsSince(start) < 60)
      QThread::msleep(5);
    state.SetIterationTime(secondsSince(start));
    program.kill();
    program.waitForFinished();
    while (heartIsOnTheScreen())
      QThread::msleep(20);
  }
}
BENCHMARK(startTheProgram)->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(5);

/// One step of a drag of a handle: from the mouse's move to the picture.
void drag(benchmark::State& state, BenchedWindow& bench) {
  bench.key(Qt::Key_3);
  moveTheMouse(state, bench, bench.onScreen(bench.handleInView(bench.reachableHandle())));
}

/// The translucent heart is blended while it moves (1), or peeled like one that stands still (0).
void dragTheHeart(benchmark::State& state) {
  BenchedWindow bench;
  bench.loadHeart();
  bench.view().view().setShortcuts({.blending = state.range(0) != 0});
  drag(state, bench);
}
BENCHMARK(dragTheHeart)
    ->Arg(1)
    ->Arg(0)
    ->ArgName("blended")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);

enum class Beside { nothing, strain, stress };

/// Has it measured beside the heart; false when it is not in time.
bool showBeside(BenchedWindow& bench, Beside what) {
  bench.window().playback().stop(); // A handle moves the own pose.
  if (what == Beside::strain) {
    const app::StrainModel& strain = bench.window().play().strain();
    bench.window().actions()["play.strain"]->trigger();
    const auto measured = [&strain] { return strain.cycle() && !strain.busy(); };
    return QTest::qWaitFor(measured, kMeasuredPatienceMs);
  }
  bench.key(Qt::Key_4);
  const app::StressModel& stress = bench.window().stress().model();
  return QTest::qWaitFor([&stress] { return stress.shown().ready(); }, kMeasuredPatienceMs);
}

/// Without anything beside it (0), beside the strain of its wall (1), or as a map of stress (2): a worker
/// measures strain in the newest pose, and the frame does not wait for it; the map is of the frame's pose.
void dragTheHeartBeside(benchmark::State& state) {
  BenchedWindow bench;
  bench.loadHeart();
  const auto beside = static_cast<Beside>(state.range(0));
  if (beside != Beside::nothing && !showBeside(bench, beside))
    return state.SkipWithError("what is to be beside the heart is not measured");
  bench.settle();
  if (beside != Beside::stress)
    bench.key(Qt::Key_3);
  moveTheMouse(state, bench, bench.onScreen(bench.handleInView(bench.reachableHandle())));
}
BENCHMARK(dragTheHeartBeside)
    ->DenseRange(0, 2)
    ->ArgName("beside")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);

/// A ball with fewer triangles while it moves where it is large (1), or with all of them (0).
void dragABall(benchmark::State& state) {
  BenchedWindow bench;
  bench.addBalls(1, int(state.range(0)));
  bench.view().view().setShortcuts({.fewerTriangles = state.range(1) != 0});
  drag(state, bench);
  state.counters["vertices"] = double(bench.document().organs().front()->mesh->points.rows());
}
BENCHMARK(dragABall)
    ->Args({6, 1})
    ->ArgsProduct({{8, 9}, {1, 0}})
    ->ArgNames({"levels", "proxy"})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

/// A surface that lies beside the project, in thirty handles.
void dragAnOrgan(benchmark::State& state, const char* file) {
  BenchedWindow bench;
  if (!bench.loadShared(file))
    return state.SkipWithError(kNotShared);
  drag(state, bench);
  state.counters["vertices"] = double(bench.document().organs().front()->mesh->points.rows());
}
BENCHMARK_CAPTURE(dragAnOrgan, liver, "liver.vtk")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);
BENCHMARK_CAPTURE(dragAnOrgan, bunny, "bunny.obj")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

/// Balls in the same handles, of which the one in front of them all is dragged.
void dragAPatient(benchmark::State& state) {
  BenchedWindow bench;
  bench.addPatient(int(state.range(0)));
  drag(state, bench);
}
BENCHMARK(dragAPatient)
    ->Arg(3)
    ->Arg(95)
    ->ArgName("organs")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

/// The first step of a drag under the locks of two organs. What a hand does on the way is drawn (the locks in
/// the list, the handle under the mouse, then held). The locks were set long before, so that a worker has
/// made their volume forms (1), or right before, so that the drag does without (0); `firstLockedMove` has the
/// third way.
void firstLockedStep(benchmark::State& state) {
  constexpr int kWorkerBegins = 400; // ms
  for (auto _ : state) {
    BenchedWindow bench;
    bench.loadHeart();
    bench.key(Qt::Key_3);
    for (std::size_t organ = 0; organ < 2; ++organ)
      bench.window().workspace().perform(
          document::setVolumeLocked(bench.document().organs()[organ]->id, true));
    if (state.range(0) != 0) {
      QTest::qWait(kWorkerBegins);
      bench.settle();
    }
    const QPoint at = bench.onScreen(bench.handleInView(bench.reachableHandle()));
    bench.untilDrawn([&] { QTest::mouseMove(&bench.view(), at); });
    bench.untilDrawn([&] { QTest::mousePress(&bench.view(), Qt::LeftButton, Qt::NoModifier, at); });
    state.SetIterationTime(bench.untilDrawn([&] { QTest::mouseMove(&bench.view(), at + QPoint(12, 6)); }));
    QTest::mouseRelease(&bench.view(), Qt::LeftButton, Qt::NoModifier, at);
    bench.settle();
  }
}
BENCHMARK(firstLockedStep)
    ->Arg(1)
    ->Arg(0)
    ->ArgName("prepared")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(5);

/// A press on a handle until it is drawn as held.
void pressAHandle(benchmark::State& state) {
  BenchedWindow bench;
  bench.loadHeart();
  bench.key(Qt::Key_3);
  const QPoint at = bench.onScreen(bench.handleInView(bench.reachableHandle()));
  QTest::mouseMove(&bench.view(), at);
  bench.settle();
  for (auto _ : state) {
    state.SetIterationTime(
        bench.untilDrawn([&] { QTest::mousePress(&bench.view(), Qt::LeftButton, Qt::NoModifier, at); }));
    QTest::mouseRelease(&bench.view(), Qt::LeftButton, Qt::NoModifier, at);
    bench.settle();
  }
}
BENCHMARK(pressAHandle)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(10);

/// A frame of the beating heart: the clock has moved on, until that instant is drawn and all that goes with
/// it is done. Its wall is blended (1) or peeled (0), as in `dragTheHeart`.
void playTheHeart(benchmark::State& state) {
  BenchedWindow bench;
  bench.loadHeart();
  bench.view().view().setShortcuts({.blending = state.range(0) != 0});
  bench.key(Qt::Key_5);
  if (!bench.window().playback().player().playing())
    bench.key(Qt::Key_Space);
  for (auto _ : state) {
    bench.now_ += 1.0 / 30;
    state.SetIterationTime(bench.untilDrawn([&] { bench.window().playback().advance(); }));
  }
}
BENCHMARK(playTheHeart)
    ->Arg(1)
    ->Arg(0)
    ->ArgName("blended")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(120);

/// Another rate, until the stress over the whole cycle is there: the heart stands still (0), or beats in the
/// meantime (1).
void stressOverACycle(benchmark::State& state) {
  BenchedWindow bench;
  bench.loadHeart();
  app::Playback& playback = bench.window().playback();
  playback.pause();
  bench.key(Qt::Key_4);
  const live::LiveStress& stress = bench.window().workspace().stress();
  const auto found = [&] { return stress.cycle() != nullptr; };
  bench.waitUntil(found);
  bench.settle();
  if (state.range(0) != 0)
    playback.play();
  for (auto _ : state) {
    const auto start = Clock::now();
    playback.setRate(playback.player().ratePerMinute() > 70 ? 60 : 75);
    bench.waitUntil([&] { return !found(); });
    while (!found() && secondsSince(start) < 20) {
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
      if (!playback.player().playing())
        continue;
      bench.now_ += 1.0 / 30;
      bench.untilDrawn([&] { playback.advance(); });
    }
    state.SetIterationTime(secondsSince(start));
  }
  state.counters["points"] = double(stress.mesh()->points.rows());
  state.counters["handles"] = double(stress.gradients()->handles());
}
BENCHMARK(stressOverACycle)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(5);

/// A control of the circulation is moved, until the heart and the curves that follow it are drawn.
void moveAControl(benchmark::State& state) {
  BenchedWindow bench;
  bench.loadHeart();
  bench.key(Qt::Key_5);
  bench.window().playback().pause();
  bench.window().findChild<QAbstractButton*>(QStringLiteral("scenario.rest"))->click();
  const auto& playback = bench.window().playback();
  const auto follows = [&] {
    return dynamic_cast<const heart::CourseHeartbeat*>(playback.sequence()) != nullptr;
  };
  bench.waitUntil(follows);
  bench.settle();
  auto* slider =
      bench.window().findChild<QWidget*>(QStringLiteral("circulation.stressedVolume"))->findChild<QSlider*>();
  int step = 3;
  for (auto _ : state) {
    const auto* before = playback.sequence();
    const auto start = Clock::now();
    slider->setValue(slider->value() + step);
    while (playback.sequence() == before && secondsSince(start) < 5)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    bench.untilDrawn([] {});
    state.SetIterationTime(secondsSince(start));
    step = -step;
    bench.settle();
  }
}
BENCHMARK(moveAControl)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(20);

/// A click on one of many organs, until it is drawn as chosen.
void clickAnOrgan(benchmark::State& state) {
  BenchedWindow bench;
  bench.addBalls(int(state.range(0)), 4);
  int organ = 0;
  for (auto _ : state) {
    organ = (organ + 1) % int(state.range(0));
    const Points& points = bench.document().organs()[std::size_t(organ)]->mesh->points;
    const QPoint at = bench.onScreen(points.colwise().mean().transpose());
    QTest::mouseMove(&bench.view(), at);
    state.SetIterationTime(
        bench.untilDrawn([&] { QTest::mouseClick(&bench.view(), Qt::LeftButton, Qt::NoModifier, at); }));
    bench.settle();
  }
  bench.countWork(state);
}
BENCHMARK(clickAnOrgan)->Arg(3)->Arg(95)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(10);

class BenchedAtlas : public tests::AtlasWindow {
public:
  BenchedAtlas() {
    application();
    SetUp();
  }
  ~BenchedAtlas() override { TearDown(); }
  void TestBody() override {}

  /// From opening until organs are seen, until all are there to be looked at, and until they are taken, ms.
  void timeImport(benchmark::State& state) {
    const auto start = Clock::now();
    double first = 0;
    window().files().open({QString::fromStdString(file().string())});
    waitUntil([&] {
      if (first == 0 && !view().view().organs().empty())
        first = 1000 * secondsSince(start);
      return window().imports().isOpen() || !document().organs().empty();
    });
    draw();
    state.counters["first"] = first;
    state.counters["allSeen"] = 1000 * secondsSince(start);
    settle();
    time(state, "accept", [this] {
      if (window().imports().isOpen())
        window().imports().accept();
    });
  }
  /// Until the step is done and drawn; then what is left to do is done.
  void time(benchmark::State& state, const std::string& name, const std::function<void()>& step) {
    const auto start = Clock::now();
    const std::clock_t work = std::clock();
    step();
    draw();
    state.counters[name] = 1000 * secondsSince(start);
    state.counters[name + "Processor"] = processorMs(work);
    settle();
  }

private:
  void draw() {
    QCoreApplication::processEvents();
    view().renderPending();
    view().renderWindow()->WaitForCompletion();
  }
};

/// The steps of an afternoon with an atlas of 95 organs; each is a counter, in ms, beside what all threads
/// worked for it.
void workWithTheAtlas(benchmark::State& state) {
  if (!std::filesystem::exists(BenchedAtlas::file()))
    return state.SkipWithError("shared/organs/abdomen_seg.nrrd is absent");
  for (auto _ : state) {
    BenchedAtlas atlas;
    atlas.timeImport(state);
    atlas.time(state, "find", [&] { atlas.find(); });
    atlas.time(state, "choose", [&] { atlas.choose(); });
    atlas.time(state, "isolate", [&] { atlas.isolate(); });
    atlas.time(state, "surround", [&] { atlas.surround(); });
    atlas.time(state, "lock", [&] { atlas.lock(); });
    atlas.time(state, "grab", [&] { atlas.grab(); });
    atlas.time(state, "move", [&] { atlas.move({30, -20}); });
    atlas.time(state, "release", [&] { atlas.release({30, -20}); });
    atlas.time(state, "showAll", [&] { atlas.showAll(); });
  }
}
BENCHMARK(workWithTheAtlas)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

} // namespace
} // namespace viscera::bench
