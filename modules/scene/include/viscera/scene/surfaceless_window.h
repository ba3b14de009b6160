#pragma once

#include <memory>

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace viscera::scene {

/// A render window that works without a display: an OpenGL context by EGL without a surface, on a graphics
/// processor or in software. One thread at a time; the context is current on the thread that made it.
class SurfacelessWindow {
public:
  /// `width x height` device pixels; `pixelRatio` device pixels a logical one (sets the DPI). Throws `Error`
  /// (exit code 69, service unavailable) that names what EGL lacks and which packages help.
  SurfacelessWindow(int width, int height, double pixelRatio = 1);
  ~SurfacelessWindow();
  SurfacelessWindow(const SurfacelessWindow&) = delete;
  SurfacelessWindow& operator=(const SurfacelessWindow&) = delete;

  vtkRenderWindow* window() const;
  /// An interactor for simulated events, created on the first call.
  vtkRenderWindowInteractor* interactor();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
