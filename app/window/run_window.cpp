#include "window/run_window.h"

#include <QApplication>
#include <QMainWindow>

namespace viscera::app {

int runWindow(int argc, char** argv, const WindowOptions&) {
  QApplication application(argc, argv);
  QMainWindow window;
  window.show();
  return QApplication::exec();
}

} // namespace viscera::app
