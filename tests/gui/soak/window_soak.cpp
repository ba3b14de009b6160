#include "window_soak.h"

#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QTest>

#include <functional>

#include <vtkInteractorObserver.h>

#include "viscera/live/player.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/compare/comparison.h"
#include "window/movie/movie_recorder.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/view/view_area.h"

namespace viscera::tests {
namespace {

constexpr int kRate = 150;          ///< Beats a minute.
constexpr int kLongestWait = 90000; ///< ms; the sample heart may have to be made first.
/// Seconds of playing that belong to the occupation before: the page of another mode is laid out, and the
/// first frame waits for that.
constexpr double kAftermath = 1;
/// A job of the window, such as the measuring of a cycle, has one of the processors that draw.
const std::string kJob = "a job";

/// Handles the window's events until `done`, or for so long; the soak goes on in either case.
void waitFor(const std::function<bool()>& done, int milliseconds = kLongestWait) {
  [[maybe_unused]] const bool came = QTest::qWaitFor(done, milliseconds);
}

} // namespace

WindowSoak::WindowSoak() {
  settings_ = std::make_unique<app::Settings>(folder_.filePath(QStringLiteral("viscera.ini")));
  for (const char* kind : {"files/pictures", "record/folder"})
    settings_->setValue(kind, folder_.path());
  window_ = std::make_unique<app::MainWindow>(*settings_, coordinates::builtInRegistry(),
                                              live::Player::steadyClock());
  window_->sessions().setQuestion([](const QString&) { return app::SessionFiles::Answer::discard; });
  window_->sessions().startAutosave(folder_.filePath(QStringLiteral("recovery")).toStdString());
  window_->resize(1280, 800);
  window_->show();
  window_->setMode("play");
  window_->samples().load(QStringLiteral("heart"), true);
  waitFor([this] { return window_->playback().player().playing(); });
  window_->playback().setRate(kRate);
  QObject::connect(window_->viewArea().view(), &QOpenGLWidget::frameSwapped, [this] { onFrame(); });
}

WindowSoak::~WindowSoak() {
  window_->close();
}

void WindowSoak::run(double seconds, const std::function<void(const SoakSample&)>& tell) {
  seconds_ = seconds;
  tell_ = tell;
  clock_.start();
  present_ = {};
  QTimer second;
  second.setTimerType(Qt::PreciseTimer);
  QObject::connect(&second, &QTimer::timeout, [this] { endSecond(); });
  second.start(1000);
  while (!over()) {
    playFor(20, "playing");
    drag();
    playFor(10, "playing");
    compare();
    playFor(10, "playing");
    record();
    ++rounds_;
  }
}

void WindowSoak::playFor(double seconds, const char* occupation) {
  occupation_ = occupation;
  window_->setMode("play");
  if (!window_->playback().player().playing())
    window_->playback().play();
  QElapsedTimer timer;
  timer.start();
  waitFor([&] { return over() || static_cast<double>(timer.elapsed()) / 1000 >= seconds; },
          static_cast<int>(1000 * seconds) + 1000);
}

/// For a view at rest VTK keeps textures of the view's size in the present mode.
void WindowSoak::rest() {
  QCoreApplication::processEvents(); // The mode is laid out.
  waitFor([this] { return window_->workspace().jobs().idle() && window_->viewArea().view()->atRest(); });
}

/// Another handle in each round. The view comes to rest, as for someone who looks at what the drag did, and
/// the change is undone, so that the heart that beats on is the same. It rests in Play, too, so that each
/// round ends with textures of one size.
void WindowSoak::drag() {
  occupation_ = "a drag";
  window_->setMode("deform");
  app::ViewWidget& view = *window_->viewArea().view();
  vtkVisceraHandleSetRepresentation* handles = view.view().handles();
  const Vec3 place = handles->GetPosition(7 * rounds_ % handles->GetNumberOfHandles());
  double display[3];
  vtkInteractorObserver::ComputeWorldToDisplay(view.view().renderer(), place.x(), place.y(), place.z(),
                                               display);
  const QPoint from(qRound(display[0]), qRound(view.height() - 1 - display[1]));
  QTest::mouseMove(&view, from);
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
  for (int step = 1; step <= 20; ++step) {
    QTest::mouseMove(&view, from + QPoint(2 * step, -step));
    QTest::qWait(40);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, from + QPoint(40, -20));
  rest();
  while (window_->workspace().undo().canUndo() &&
         *window_->workspace().state().pose != window_->workspace().state().rig->restPositions())
    window_->workspace().undo().undo();
  window_->setMode("play");
  rest();
  playFor(kAftermath, "a drag");
}

void WindowSoak::compare() {
  occupation_ = "two views";
  window_->play().comparison().showSameOrgan();
  playFor(10, "two views");
  window_->play().comparison().end();
  playFor(kAftermath, "two views");
}

void WindowSoak::record() {
  occupation_ = "a recording";
  auto* button = window_->findChild<QAbstractButton*>(QStringLiteral("recordButton"));
  button->click();
  waitFor([this] { return !window_->play().recorder().running(); });
  for (const QString& movie : QDir(folder_.path()).entryList({QStringLiteral("*.ogv")}))
    QFile::remove(folder_.filePath(movie));
  playFor(kAftermath, "a recording");
}

void WindowSoak::onFrame() {
  ++present_.frames;
  if (present_.occupation.empty() && !window_->workspace().jobs().idle())
    present_.occupation = kJob;
  const bool playing = window_->playback().player().playing();
  const MachineUse machine = machine_.take();
  if (sinceFrame_.isValid() && playing) {
    const double ms = static_cast<double>(sinceFrame_.nsecsElapsed()) / 1e6;
    if (ms - machine.pausedMs > present_.longestMs - present_.machine.pausedMs) {
      present_.longestMs = ms;
      present_.machine = machine;
    }
  }
  playing ? static_cast<void>(sinceFrame_.start()) : sinceFrame_.invalidate();
}

/// What another occupation has begun belongs to it until the second is over.
void WindowSoak::endSecond() {
  if (present_.occupation.empty() || occupation_ != kPlaying)
    present_.occupation = occupation_;
  present_.seconds = static_cast<double>(clock_.elapsed()) / 1000;
  present_.use = processUse();
  tell_(present_);
  present_ = {};
  present_.occupation = occupation_ == kPlaying ? std::string() : occupation_;
}

} // namespace viscera::tests
