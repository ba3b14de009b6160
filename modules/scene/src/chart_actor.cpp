#include "chart_actor.h"

#include <vtkObjectFactory.h>

#include "text_guard.h"

namespace viscera::scene {

vtkStandardNewMacro(ChartActor);

int ChartActor::RenderOverlay(vtkViewport* viewport) {
  const TextGuard guard;
  return Superclass::RenderOverlay(viewport);
}

} // namespace viscera::scene
