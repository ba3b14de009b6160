#include "printed.h"

#include <QString>

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace viscera::tests {
namespace {

std::string& kept() {
  static std::string text;
  return text;
}

void keepOfQt(QtMsgType type, const QMessageLogContext&, const QString& text) {
  // Of the platform: it cannot know what a virtual display does with the window.
  if (type == QtDebugMsg || type == QtInfoMsg || text.contains(QLatin1String("propagateSizeHints")) ||
      text.contains(QLatin1String("XDG_RUNTIME_DIR")) || text.contains(QLatin1String("QXcbConnection")) ||
      text.startsWith(QLatin1String("qt.qpa")))
    return;
  kept() += "Qt says: " + text.toStdString() + "; ";
}

class KeepingWindow final : public vtkOutputWindow {
public:
  static KeepingWindow* New();
  vtkTypeMacro(KeepingWindow, vtkOutputWindow) void DisplayText(const char* text) override {
    kept() += std::string("VTK says: ") + text + "; ";
  }
};
vtkStandardNewMacro(KeepingWindow)

} // namespace

void keepPrinted() {
  qInstallMessageHandler(keepOfQt);
  KeepingWindow* window = KeepingWindow::New();
  vtkOutputWindow::SetInstance(window);
  window->Delete();
}

std::string takePrinted() {
  return std::exchange(kept(), {});
}

} // namespace viscera::tests
