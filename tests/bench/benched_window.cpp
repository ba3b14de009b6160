#include "benched_window.h"

#include <QApplication>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include <vtkRenderWindow.h>

#include "build_paths.h"
#include "session_fixture.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/document/open_files.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "window/run_window.h"

namespace viscera::bench {

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double processorMs(std::clock_t start) {
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

QApplication& application() {
  static int count = 1;
  static char name[] = "bench_window";
  static char* arguments[] = {name, nullptr};
  static const auto made = [] {
    qputenv("QT_QPA_PLATFORM", "xcb");
    app::prepareForApplication();
    auto application = std::make_unique<QApplication>(count, arguments);
    app::setUpApplication(*application);
    return application.release(); // It outlives everything: at the exit Qt's own parts go first.
  }();
  return *made;
}

BenchedWindow::BenchedWindow() {
  application();
  SetUp();
}

void BenchedWindow::loadHeart() {
  window().samples().load(QStringLiteral("heart"), false);
  waitUntil([this] { return !document().organs().empty() && window().playback().sequence(); });
  settle();
}

bool BenchedWindow::loadShared(const std::string& file) {
  const std::filesystem::path surface = std::filesystem::path(VISCERA_SHARED_ORGANS) / file;
  if (!std::filesystem::exists(surface))
    return false;
  window().workspace().perform(document::addOrgans({{document::readOrgan(surface), -1}}));
  addHandles(deformation::placeHandles(*document().organs().front()->mesh, {30}));
  return true;
}

void BenchedWindow::addBallsAlone(int organs, int levels) {
  std::vector<document::NewOrgan> balls;
  for (int i = 0; i < organs; ++i)
    balls.push_back(tests::ball("Ball " + std::to_string(i), organs > 1 ? 30 : 60, levels,
                                Vec3(70.0 * (i % 10), 0, 70.0 * (i / 10))));
  window().workspace().perform(document::addOrgans(std::move(balls)));
}

void BenchedWindow::addHandles(const Points& places) {
  std::vector<document::NewHandle> handles;
  for (Eigen::Index row = 0; row < places.rows(); ++row)
    handles.push_back({places.row(row).transpose()});
  window().workspace().perform(document::addHandles(handles));
  settle();
  key(Qt::Key_F);
}

void BenchedWindow::addBalls(int organs, int levels) {
  addBallsAlone(organs, levels);
  addHandles(deformation::enclosingHandles(document().organs().front()->mesh->points));
}

void BenchedWindow::addPatient(int organs) {
  addBallsAlone(organs, 4);
  Points all(0, 3);
  for (const auto& organ : document().organs()) {
    const Points& points = organ->mesh->points;
    all.conservativeResize(all.rows() + points.rows(), 3);
    all.bottomRows(points.rows()) = points;
  }
  const Points box = deformation::enclosingHandles(all);
  Points handles(box.rows() + 1, 3);
  // One in front of their middle, where the mouse takes it.
  const Bounds bounds = boundsOf(all);
  handles << box, bounds.center().x(), bounds.low.y() - 20, bounds.center().z();
  window().workspace().selection().setOrgan({}); // So that all of them come into the picture.
  addHandles(handles);
}

bool BenchedWindow::load(const std::string& scene) {
  const auto number = [&scene] { return std::stoi(scene.substr(scene.find('_') + 1)); };
  if (scene == "liver")
    return loadShared("liver.vtk");
  if (scene == "heart")
    loadHeart();
  else if (scene.starts_with("ball_"))
    addBalls(1, number());
  else
    addPatient(number());
  return true;
}

double BenchedWindow::untilDrawn(const std::function<void()>& event) {
  const auto start = Clock::now();
  const std::clock_t work = std::clock();
  event();
  QCoreApplication::processEvents();
  view().renderPending();
  view().renderWindow()->WaitForCompletion();
  worked_ += processorMs(work);
  ++events_;
  return secondsSince(start);
}

void moveTheMouse(benchmark::State& state, BenchedWindow& bench, const QPoint& from) {
  QTest::mouseMove(&bench.view(), from);
  QTest::mousePress(&bench.view(), Qt::LeftButton, Qt::NoModifier, from);
  int step = 0;
  for (auto _ : state) {
    ++step;
    const QPoint to = from + QPoint(qRound(40 * std::sin(0.3 * step)), qRound(30 * std::sin(0.2 * step)));
    state.SetIterationTime(bench.untilDrawn([&] { QTest::mouseMove(&bench.view(), to); }));
  }
  QTest::mouseRelease(&bench.view(), Qt::LeftButton, Qt::NoModifier, from);
  bench.settle();
}

} // namespace viscera::bench
