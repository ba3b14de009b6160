#include "viscera/presentation/camera.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace viscera::presentation {

Camera cameraOf(const scene::OrganView& view) {
  vtkCamera& eye = *view.renderer()->GetActiveCamera();
  Camera camera;
  eye.GetPosition(camera.position.data());
  eye.GetFocalPoint(camera.focus.data());
  eye.GetViewUp(camera.up.data());
  camera.angleDegrees = eye.GetViewAngle();
  camera.parallel = eye.GetParallelProjection() != 0;
  camera.parallelScaleMm = eye.GetParallelScale();
  return camera;
}

void lookFrom(const Camera& camera, scene::OrganView& view) {
  if (camera.position == camera.focus)
    return;
  vtkCamera& eye = *view.renderer()->GetActiveCamera();
  eye.SetPosition(camera.position.data());
  eye.SetFocalPoint(camera.focus.data());
  eye.SetViewUp(camera.up.data());
  eye.SetViewAngle(camera.angleDegrees);
  eye.SetParallelProjection(camera.parallel ? 1 : 0);
  eye.SetParallelScale(camera.parallelScaleMm);
  view.renderer()->ResetCameraClippingRange();
}

} // namespace viscera::presentation
