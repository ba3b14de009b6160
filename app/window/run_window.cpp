#include "window/run_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFontInfo>
#include <QPixmap>
#include <QSurfaceFormat>
#include <QTimer>
#include <QTranslator>
#include <QVTKOpenGLNativeWidget.h>

#include <cstdio>
#include <exception>
#include <memory>

#include "available_systems.h"
#include "viscera/core/error.h"
#include "viscera/scene/text_font.h"
#include "window/application.h"
#include "window/import/import_controller.h"
#include "window/main_window.h"
#include "window/modes/mode_controller.h"
#include "window/session/exit_handler.h"
#include "window/session/session_files.h"
#include "window/style/language.h"
#include "window/view/view_actions.h"
#include "window/view/view_area.h"
#include "window/widgets/first_picture.h"
#include "window/work/heap.h"

namespace viscera::app {
namespace {

constexpr int kServiceUnavailable = 69;
constexpr int kCannotCreate = 73;
constexpr int kSoftware = 70;
constexpr int kScreenshotWidth = 1600;
constexpr int kScreenshotHeight = 1000;
constexpr double kFrameSeconds = 1.0 / 25.0;
constexpr double kPlayedSeconds = 2.64; ///< Ends in the ejection at 75 beats a minute.
constexpr int kLongestWait = 180000;    ///< ms, for a sample organ that has to be made first.
constexpr int kSettle = 400;            ///< ms, for what the window still has to draw.

/// Qt would abort the program where there is no display.
bool displayThere() {
#if defined(Q_OS_LINUX)
  if (!qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    return true;
  return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
#else
  return true;
#endif
}

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

/// Loads the files of the options, or the sample organ; with `play` its motion starts.
void load(MainWindow& window, const WindowOptions& options, bool play) {
  QStringList files;
  for (const std::string& file : options.files)
    files.push_back(QString::fromStdString(file));
  if (files.isEmpty())
    window.samples().load(QString::fromStdString(options.sample), play);
  else
    window.files().open(files);
}

/// Shows the window without the user's settings, lets it load what the options say, plays two and a half
/// seconds of its motion on a clock of its own (the same on every machine), writes the picture of the whole
/// window and returns the exit code.
int takePicture(const WindowOptions& options, InstalledLanguage& language) {
  Settings settings{QString()};
  double now = 0;
  AvailableSystems systems = availableSystems(options.pluginPath);
  language.addTextsOf(systems.registry);
  MainWindow window(settings, std::move(systems.registry), [&now] { return now; });
  window.setTheme(themeFromName(QString::fromStdString(options.theme)));
  window.resize(options.width > 0 ? options.width : kScreenshotWidth,
                options.height > 0 ? options.height : kScreenshotHeight);
  window.show();
  window.setMode(options.mode);
  load(window, options, false);
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
  const bool moves = !session && mode.pose() == live::WantedPose::sequence && !mode.shown().stress;
  if (moves && window.playback().sequence()) {
    window.playback().play();
    while (now < kPlayedSeconds) {
      now += kFrameSeconds;
      window.playback().advance();
    }
  }
  waitWhile(kSettle);
  if (!session)
    window.views().lookFrom(scene::StandardView::anterior);
  waitWhile(kSettle);
  waitFor([&window] { return window.viewArea().view()->atRest(); }, kLongestWait);
  if (!window.grab().save(QString::fromStdString(options.screenshot), "PNG")) {
    std::fprintf(stderr, "viscera: cannot write %s\n", options.screenshot.c_str());
    return kCannotCreate;
  }
  return 0;
}

/// English has translations, too, of the texts with a number in them alone: "1 vertex", "17 vertices". Those
/// of other languages are installed after it and come first.
void installEnglishPlurals(QApplication& application) {
  auto* english = new QTranslator(&application);
  if (english->load(QStringLiteral(":/viscera/translations/viscera_en")))
    QApplication::installTranslator(english);
}

} // namespace

void prepareForApplication() {
  keepHeapSmall();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
}

void setUpApplication(QApplication& application) {
  QApplication::setApplicationName(QStringLiteral("viscera"));
  QApplication::setApplicationDisplayName(QStringLiteral("Viscera"));
  QApplication::setApplicationVersion(QStringLiteral(VISCERA_VERSION));
  installEnglishPlurals(application);
  QLocale::setDefault(localeOf(QStringLiteral("en")));
  scene::setTextFont(QFontInfo(QApplication::font()).family().toStdString());
}

void keepWithoutDisplay(SessionFiles& sessions) noexcept {
  try {
    const bool kept = sessions.writeRecoveryFile();
    std::fputs(kept ? "viscera: the display has gone; unsaved work is kept, and offered at the next start\n"
                    : "viscera: the display has gone\n",
               stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "viscera: the display has gone, and unsaved work cannot be kept: %s\n",
                 reportsShortMemory(error) ? "there is not enough memory" : error.what());
  }
}

int runWindow(int argc, char** argv, const WindowOptions& options) {
  if (!displayThere()) {
    std::fputs("viscera: there is no display for the window (try `viscera play heartbeat` or `viscera "
               "render`, which "
               "need none)\n",
               stderr);
    return kServiceUnavailable;
  }
  prepareForApplication();
  Application application(argc, argv);
  setUpApplication(application);
  const QString language = QString::fromStdString(options.language);
  if (!options.screenshot.empty()) {
    InstalledLanguage installed(languageFor(language, QLocale::c()));
    return takePicture(options, installed);
  }

  Settings settings(options.freshSettings ? QString() : Settings::standardFile());
  InstalledLanguage installed(languageFor(
      language.isEmpty() ? settings.value("window/language").toString() : language, QLocale::system()));
  if (!options.theme.empty())
    settings.setValue("window/theme", QString::fromStdString(options.theme));
  std::unique_ptr<QSplashScreen> start;
  if (options.files.empty())
    start = showStartPicture(QString::fromStdString(options.sample),
                             themeOf(themeFromName(settings.value("window/theme", "dark").toString())));
  AvailableSystems systems = availableSystems(options.pluginPath);
  installed.addTextsOf(systems.registry);
  MainWindow window(settings, std::move(systems.registry), live::Player::steadyClock());
  application.setGuard(
      [&window](const std::function<void()>& work) { return window.workspace().guarded(work); });
  if (!options.theme.empty())
    window.setTheme(themeFromName(QString::fromStdString(options.theme)));
  if (options.width > 0 && options.height > 0)
    window.resize(options.width, options.height);
  window.setMode(options.mode);
  if (options.files.empty()) // A worker makes the organ while the window is drawn for the first time.
    load(window, options, true);
  window.show();
  if (start)
    start->finish(&window);
  if (options.files.empty())
    window.showWelcome(settings.value("window/welcome", true).toBool());
  QStringList problems;
  for (const Text& problem : systems.problems)
    problems.push_back(asSentence(problem));
  if (!problems.isEmpty()) // In one message, because a second one would replace the first.
    window.workspace().say({Message::Severity::warning, problems.join(QLatin1Char('\n')), {}, 0});
  if (!options.freshSettings) {
    window.sessions().startAutosave(document::standardRecoveryFolder());
    window.sessions().offerRecovery();
  }
  if (!options.files.empty())
    QTimer::singleShot(0, &window, [&] { load(window, options, true); });
  const ExitHandler unasked([&window] { keepWithoutDisplay(window.sessions()); });
  const int code = QApplication::exec();
  application.setGuard({}); // The window is about to go.
  return code;
}

} // namespace viscera::app
