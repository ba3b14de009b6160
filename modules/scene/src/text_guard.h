#pragma once

#include <mutex>

#include <vtkOpenGLContextActor.h>

namespace viscera::scene {

/// Makes VTK's text rendering thread-safe: VTK has one text renderer (FreeType) for the whole program, which
/// is made for one thread. After the first call a mutex guards it, so that windows of several threads may
/// draw text. Call it before creating a view or a chart. Thread-safe; cheap.
void guardText();

/// Holds that mutex while code draws text without going through the guarded renderer, as VTK's charts do,
/// which access its caches.
class TextGuard {
public:
  TextGuard();

private:
  std::scoped_lock<std::recursive_mutex> lock_;
};

/// The context actor for charts, which holds a `TextGuard` while it draws.
class ChartActor : public vtkOpenGLContextActor {
public:
  static ChartActor* New();
  vtkTypeMacro(ChartActor, vtkOpenGLContextActor)

      int RenderOverlay(vtkViewport* viewport) override;
};

} // namespace viscera::scene
