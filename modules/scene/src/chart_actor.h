#pragma once

#include <vtkOpenGLContextActor.h>

namespace viscera::scene {

/// What draws a chart into a window: charts write text past the guarded renderer, so this one holds the
/// guard.
class ChartActor : public vtkOpenGLContextActor {
public:
  static ChartActor* New();
  vtkTypeMacro(ChartActor, vtkOpenGLContextActor)

      int RenderOverlay(vtkViewport* viewport) override;
};

} // namespace viscera::scene
