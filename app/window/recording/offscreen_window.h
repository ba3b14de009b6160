#pragma once

#include <QSize>

#include <memory>

class vtkRenderWindow;

namespace viscera::app {

/// A render window that nobody sees, with an OpenGL context of Qt's: it gets along with the program's other
/// views on the main thread, which one made by EGL directly does not. For the main thread.
class OffscreenWindow {
public:
  /// Throws `Error` (exit code 69) when there is no OpenGL 3.2.
  explicit OffscreenWindow(const QSize& size);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkRenderWindow* window() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::app
