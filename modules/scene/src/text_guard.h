#pragma once

#include <mutex>

#include <vtkOpenGLContextActor.h>

namespace viscera::scene {

/// VTK has one text renderer (FreeType) for the whole program, and it is made for one thread. From the first
/// call on it is guarded, so that windows of several threads may write; whoever makes a view or a chart calls
/// this first. Thread-safe; cheap.
void guardText();

/// Held while something writes text past that renderer: VTK's charts, which look into its caches.
class TextGuard {
public:
  TextGuard();

private:
  std::scoped_lock<std::recursive_mutex> lock_;
};

/// What draws charts: they write text past the guarded renderer, so that it holds the guard.
class ChartActor : public vtkOpenGLContextActor {
public:
  static ChartActor* New();
  vtkTypeMacro(ChartActor, vtkOpenGLContextActor)

      int RenderOverlay(vtkViewport* viewport) override;
};

} // namespace viscera::scene
