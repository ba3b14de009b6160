#include "window/picture_session.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPixmap>

#include <cstdio>

#include "available_systems.h"
#include "window/import/import_desk.h"
#include "window/main_window.h"
#include "window/modes/mode_controller.h"
#include "window/session/session_files.h"
#include "window/view/view_actions.h"
#include "window/view/view_area.h"

namespace viscera::app {
namespace {

constexpr int kCannotCreate = 73;
constexpr int kSoftware = 70;
constexpr int kWidth = 1600;
constexpr int kHeight = 1000;
constexpr double kFrame = 1.0 / 25.0;
constexpr double kPlayedSeconds = 2.54; ///< Ends in the ejection at 75 beats a minute.
constexpr int kLongestWait = 180000;    ///< ms, for a sample organ that has to be made first.
constexpr int kSettle = 400;            ///< ms, for what the window still has to draw.

bool waitFor(const std::function<bool()>& done, int milliseconds) {
  QElapsedTimer timer;
  timer.start();
  while (!done() && timer.elapsed() < milliseconds)
    QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
  return done();
}

void waitWhile(int milliseconds) {
  waitFor([] { return false; }, milliseconds);
}

} // namespace

int takePicture(const WindowOptions& options) {
  Settings settings{QString()};
  double now = 0;
  MainWindow window(settings, availableSystems(options.pluginPath).registry, [&now] { return now; });
  window.setTheme(themeFromName(QString::fromStdString(options.theme)));
  window.resize(options.width > 0 ? options.width : kWidth, options.height > 0 ? options.height : kHeight);
  window.show();
  window.setMode(options.mode);
  QStringList files;
  for (const std::string& file : options.files)
    files.push_back(QString::fromStdString(file));
  if (files.isEmpty())
    window.samples().load(QString::fromStdString(options.sample), false);
  else
    window.files().open(files);
  const bool ready = waitFor(
      [&] {
        const bool shown = !window.workspace().document().organs().empty() || window.imports().isOpen();
        return shown && window.workspace().jobs().idle();
      },
      kLongestWait);
  if (!ready) {
    std::fputs("viscera: the organs could not be loaded for the picture\n", stderr);
    return kSoftware;
  }
  const bool session = !window.sessions().file().isEmpty(); // It has a view of its own.
  const Mode& mode = window.modes().present();
  const bool moves = !session && mode.pose() == motion::WantedPose::sequence && !mode.shown().stress;
  if (moves && window.playback().sequence()) {
    window.playback().play();
    while (now < kPlayedSeconds) {
      now += kFrame;
      window.playback().advance();
    }
  }
  waitWhile(kSettle);
  if (!session)
    window.views().lookFrom(scene::StandardView::anterior);
  waitWhile(kSettle);
  if (!window.grab().save(QString::fromStdString(options.screenshot), "PNG")) {
    std::fprintf(stderr, "viscera: cannot write %s\n", options.screenshot.c_str());
    return kCannotCreate;
  }
  return 0;
}

} // namespace viscera::app
