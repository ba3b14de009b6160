#include "window_test.h"

#include <QApplication>
#include <QDir>
#include <QListWidget>
#include <QTest>

#include <vtkInteractorObserver.h>
#include <vtkRenderer.h>

#include "build_paths.h"
#include "shapes.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/session/session_files.h"
#include "window/view/view_area.h"

namespace viscera::tests {
namespace {
constexpr int kLongestWait = 120000 * VISCERA_TEST_PATIENCE; ///< ms, also on a busy machine.
constexpr int kDragSteps = 8;
} // namespace

void WindowTest::SetUp() {
  if (coarseSamples())
    coarse_.emplace();
  settings_ = std::make_unique<app::Settings>(path(QStringLiteral("viscera.ini")));
  QDir().mkpath(path(QStringLiteral("pictures")));
  settings_->setValue("files/pictures", path(QStringLiteral("pictures")));
  reopenWindow();
}

void WindowTest::TearDown() {
  endWindow();
}

void WindowTest::reopenWindow() {
  if (window_) {
    window_->sessions().setQuestion([](const QString&) { return app::SessionFiles::Answer::discard; });
    window_->close();
  }
  window_.reset();
  window_ = std::make_unique<app::MainWindow>(*settings_, registry(), [this] { return now_; });
  window_->sessions().setQuestion([](const QString&) { return app::SessionFiles::Answer::discard; });
  window_->resize(1280, 800);
  if (const auto size = viewSize())
    window_->viewArea().view()->setMaximumSize(*size);
  window_->show();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  settle();
}

app::ViewWidget& WindowTest::view() {
  return *window_->viewArea().view();
}

QString WindowTest::sphereFile(const QString& name, double radius) {
  const QString file = path(name);
  medical_io::writeSurface(file.toStdString(), sphere(4, radius));
  return file;
}

void WindowTest::open(const QString& file) {
  window().files().open({file});
  settle();
}

bool WindowTest::waitUntil(const std::function<bool()>& done) {
  return QTest::qWaitFor(done, kLongestWait);
}

void WindowTest::settle() {
  QTest::qWait(50);
  waitUntil([this] { return window().workspace().jobs().idle(); });
  QTest::qWait(50);
  waitUntil([this] { return view().atRest() || !view().isVisible(); });
}

void WindowTest::handleEvents() {
  constexpr int kPasses = 5; // What is due without delay comes after all else.
  for (int pass = 0; pass < kPasses; ++pass)
    QCoreApplication::processEvents();
}

void WindowTest::chooseSequence(const char* id) {
  auto& list = find<QListWidget>("sequenceList");
  for (int row = 0; row < list.count(); ++row)
    if (list.item(row)->data(Qt::UserRole) == QLatin1String(id)) {
      Q_EMIT list.itemClicked(list.item(row));
      return settle(); // The list may be another one now.
    }
  throw std::runtime_error(std::string("There is no sequence ") + id);
}

QPoint WindowTest::onScreen(const Vec3& point) {
  double display[3];
  vtkInteractorObserver::ComputeWorldToDisplay(view().view().renderer(), point.x(), point.y(), point.z(),
                                               display);
  const double ratio = view().devicePixelRatioF();
  return {qRound(display[0] / ratio), qRound(view().height() - 1 - display[1] / ratio)};
}

Vec3 WindowTest::handleInView(int handle) {
  return view().view().handles()->GetPosition(handle);
}

void WindowTest::drag(const QPoint& from, const QPoint& to) {
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  for (int step = 1; step <= kDragSteps; ++step) {
    QTest::mouseMove(&view(), from + (to - from) * step / kDragSteps);
    QTest::qWait(5);
  }
  QTest::qWait(50); // The pointer was warped, too: its own late motion events have to be through.
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, to);
  settle();
}

void WindowTest::click(const QPoint& place) {
  QTest::mouseMove(&view(), place);
  QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
  settle();
}

void WindowTest::clickTwice(const QPoint& first, const QPoint& second) {
  QTest::mouseMove(&view(), first);
  QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, first);
  QTest::mouseDClick(&view(), Qt::LeftButton, Qt::NoModifier, second);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, second);
  settle();
}

void WindowTest::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QTest::keyClick(window_.get(), key, modifiers);
  settle();
}

QString WindowTest::message() {
  return window().viewArea().messages()->text();
}

int WindowTest::reachableHandle() {
  auto* handles = view().view().handles();
  const QPoint middle(view().width() / 2, view().height() / 2);
  int best = -1;
  int bestDistance = 0;
  for (int handle = 0; handle < handles->GetNumberOfHandles(); ++handle) {
    if (!handles->IsHandleVisible(handle))
      continue;
    const int distance = (onScreen(handles->GetPosition(handle)) - middle).manhattanLength();
    if (best < 0 || distance < bestDistance) {
      best = handle;
      bestDistance = distance;
    }
  }
  return best;
}

} // namespace viscera::tests
