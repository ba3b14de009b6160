#include "window/recording/offscreen_window.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

#include "viscera/core/error.h"

namespace viscera::app {
namespace {

constexpr int kServiceUnavailable = 69; // sysexits.h: EX_UNAVAILABLE
constexpr int kLogicalDpi = 72;

/// Draws into its own buffers in a context that Qt has made.
class ContextWindow : public vtkGenericOpenGLRenderWindow {
public:
  static ContextWindow* New();
  vtkTypeMacro(ContextWindow, vtkGenericOpenGLRenderWindow)

      void adopt(QOpenGLContext* context, QSurface* surface) {
    context_ = context;
    surface_ = surface;
    SetOwnContext(0);
    SetReadyForRendering(true);
    SetOffScreenRendering(1);
    SetSupportsOpenGL(1);
    SetIsDirect(1);
    SetIsCurrent(true);
    Mapped = 1;
  }
  void MakeCurrent() override { context_->makeCurrent(surface_); }
  bool IsCurrent() override { return QOpenGLContext::currentContext() == context_; }
  /// There is nothing to be shown.
  void Frame() override {}

private:
  QOpenGLContext* context_ = nullptr;
  QSurface* surface_ = nullptr;
};
vtkStandardNewMacro(ContextWindow);

} // namespace

struct OffscreenWindow::Parts {
  QOffscreenSurface surface;
  QOpenGLContext context;
  vtkSmartPointer<ContextWindow> window;
};

OffscreenWindow::OffscreenWindow(const QSize& size) : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.surface.setFormat(QSurfaceFormat::defaultFormat());
  p.surface.create();
  p.context.setFormat(p.surface.format());
  if (!p.context.create() || !p.context.makeCurrent(&p.surface))
    throw Error(kServiceUnavailable, "no OpenGL context for drawing the frames", "OpenGL",
                "close other programs that draw, or record with `viscera play`");
  p.window = vtkSmartPointer<ContextWindow>::New();
  p.window->adopt(&p.context, &p.surface);
  p.window->SetMultiSamples(0);
  p.window->SetSize(size.width(), size.height());
  p.window->SetDPI(kLogicalDpi);
  p.window->OpenGLInitContext();
  p.window->OpenGLInit();
}

OffscreenWindow::~OffscreenWindow() {
  auto& p = *parts_;
  if (!p.window)
    return;
  p.window->MakeCurrent();
  p.window->Finalize();
  p.window = nullptr;
  p.context.doneCurrent();
}

vtkRenderWindow* OffscreenWindow::window() const {
  return parts_->window;
}

} // namespace viscera::app
