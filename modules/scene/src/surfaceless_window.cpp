// GLEW has to come before any other OpenGL header.
#include <vtk_glew.h>

#include "viscera/scene/surfaceless_window.h"

#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr int kServiceUnavailable = 69; // sysexits.h: EX_UNAVAILABLE

[[noreturn]] void fail(const Text& step) {
  throw Error(kServiceUnavailable, misuse("cannot draw without a display: %1", step), "EGL",
              misuse("install libegl1 and libgl1-mesa-dri, or run under a display"));
}

EGLDisplay displayOf(EGLenum platform, void* native) {
  const auto get =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return get ? get(platform, native, nullptr) : EGL_NO_DISPLAY;
}

/// Mesa's surfaceless platform first, then the first device that any vendor offers.
EGLDisplay openDisplay() {
  EGLDisplay display = displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
    return display;
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (query && query(1, &device, &count) && count > 0) {
    display = displayOf(EGL_PLATFORM_DEVICE_EXT, device);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr))
      return display;
  }
  fail(misuse("no EGL platform works without a window system"));
}

EGLContext openContext(EGLDisplay display) {
  if (!eglBindAPI(EGL_OPENGL_API))
    fail(misuse("this EGL knows no desktop OpenGL"));
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
    config = nullptr; // EGL_KHR_no_config_context
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            2,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT)
    fail(misuse("no OpenGL 3.2 context"));
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    eglDestroyContext(display, context);
    fail(misuse("the context cannot be used without a surface"));
  }
  return context;
}

/// A render window for an EGL context that was created elsewhere. VTK 9.1 has an EGL window of its own only
/// when it was built for EGL alone, without X11.
class EglWindow : public vtkGenericOpenGLRenderWindow {
public:
  static EglWindow* New();
  vtkTypeMacro(EglWindow, vtkGenericOpenGLRenderWindow)

      void adopt(EGLDisplay display, EGLContext context) {
    display_ = display;
    context_ = context;
    SetOwnContext(1);
    ForceMaximumHardwareLineWidth =
        1; // Core profiles need not draw wide lines: VTK then makes quads of them.
    SetReadyForRendering(true);
    SetIsCurrent(true);
    SetIsDirect(1);
    SetSupportsOpenGL(1);
    SetOffScreenRendering(1);
    Mapped = 1;
  }

  void MakeCurrent() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }
  bool IsCurrent() override { return eglGetCurrentContext() == context_; }
  void Frame() override {}

  /// Begins as the base class does, but GLEW complains about a missing GLX display here, after it has loaded
  /// every function.
  void OpenGLInitContext() override {
    constexpr GLenum kNoGlxDisplay = 4; // GLEW_ERROR_NO_GLX_DISPLAY; old headers have no name for it.
    ContextCreationTime.Modified();
    if (Initialized)
      return;
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == kNoGlxDisplay;
    Initialized = GlewInitValid && GLEW_VERSION_3_2;
  }
  bool ready() const { return Initialized; }

private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};
vtkStandardNewMacro(EglWindow);

} // namespace

struct SurfacelessWindow::Parts {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  vtkSmartPointer<EglWindow> window;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor;

  ~Parts() {
    if (window) {
      window->MakeCurrent();
      interactor = nullptr;
      window->Finalize();
      window = nullptr;
    }
    if (context != EGL_NO_CONTEXT) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglDestroyContext(display, context);
    }
    // The display is shared by the whole process; terminating it would take other windows' contexts away.
  }
};

SurfacelessWindow::SurfacelessWindow(int width, int height, double pixelRatio)
    : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.display = openDisplay();
  p.context = openContext(p.display);
  p.window = vtkSmartPointer<EglWindow>::New();
  p.window->adopt(p.display, p.context);
  p.window->SetMultiSamples(0);
  p.window->SetSize(width, height);
  p.window->SetDPI(static_cast<int>(kLogicalDpi * pixelRatio + 0.5));
  p.window->OpenGLInitContext();
  if (!p.window->ready())
    fail(misuse("the driver's OpenGL is older than 3.2"));
  p.window->OpenGLInit();
}

SurfacelessWindow::~SurfacelessWindow() = default;

vtkRenderWindow* SurfacelessWindow::window() const {
  return parts_->window;
}

vtkRenderWindowInteractor* SurfacelessWindow::interactor() {
  auto& p = *parts_;
  if (!p.interactor) {
    p.interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
    p.interactor->SetRenderWindow(p.window);
    p.interactor->Initialize();
  }
  return p.interactor;
}

} // namespace viscera::scene
