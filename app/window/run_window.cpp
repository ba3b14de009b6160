#include "window/run_window.h"

#include <QApplication>
#include <QTimer>

#include <cstdio>
#include <memory>

#include "available_systems.h"
#include "window/application.h"
#include "window/main_window.h"
#include "window/picture_session.h"
#include "window/session/session_files.h"

namespace viscera::app {
namespace {

constexpr int kServiceUnavailable = 69;

/// Without a display Qt would abort the program.
bool displayThere() {
#if defined(Q_OS_LINUX)
  if (!qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    return true;
  return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
#else
  return true;
#endif
}

void begin(MainWindow& window, const WindowOptions& options) {
  window.setMode(options.mode);
  if (options.files.empty()) {
    window.samples().load(QString::fromStdString(options.sample), true);
    return;
  }
  QStringList files;
  for (const std::string& file : options.files)
    files.push_back(QString::fromStdString(file));
  window.files().open(files);
}

} // namespace

int runWindow(int argc, char** argv, const WindowOptions& options) {
  if (!displayThere()) {
    std::fputs("viscera: there is no display for the window (try `viscera play heartbeat` or `viscera "
               "render`, which "
               "need none)\n",
               stderr);
    return kServiceUnavailable;
  }
  prepareForApplication();
  QApplication application(argc, argv);
  setUpApplication(application);
  if (!options.screenshot.empty())
    return takePicture(options);

  Settings settings(options.freshSettings ? QString() : Settings::standardFile());
  if (!options.theme.empty())
    settings.setValue("window/theme", QString::fromStdString(options.theme));
  AvailableSystems systems = availableSystems(options.pluginPath);
  MainWindow window(settings, std::move(systems.registry), motion::Transport::steadyClock());
  if (!options.theme.empty())
    window.setTheme(themeFromName(QString::fromStdString(options.theme)));
  if (options.width > 0 && options.height > 0)
    window.resize(options.width, options.height);
  window.show();
  if (options.files.empty())
    window.showWelcome(settings.value("window/welcome", true).toBool());
  QStringList problems;
  for (const std::string& problem : systems.problems)
    problems.push_back(asSentence(problem));
  if (!problems.isEmpty()) // Together: a second message would take the place of the first.
    window.workspace().say({Message::Severity::warning, problems.join(QLatin1Char('\n')), {}, 0});
  if (!options.freshSettings) {
    window.sessions().startAutosave(document::standardRecoveryFolder());
    window.sessions().offerRecovery();
  }
  QTimer::singleShot(0, &window, [&] { begin(window, options); });
  return QApplication::exec();
}

} // namespace viscera::app
