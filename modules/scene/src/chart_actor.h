#pragma once

#include <vtkOpenGLContextActor.h>

namespace viscera::scene {

/// What draws charts: they write text past the guarded renderer, so that it holds the guard.
class ChartActor : public vtkOpenGLContextActor {
public:
  static ChartActor* New();
  vtkTypeMacro(ChartActor, vtkOpenGLContextActor)

      int RenderOverlay(vtkViewport* viewport) override;
};

} // namespace viscera::scene
