#pragma once

#include <vtkNew.h>

#include "viscera/scene/theme.h"

#include "before_render.h"

class vtkAnnotatedCubeActor;
class vtkRenderer;
class vtkRenderWindow;

namespace viscera::scene {

/// A small cube in the lower left corner whose faces say where the patient's right, left, front, back, head
/// and feet are. Has a renderer of its own on the layer above, turned with the main camera.
class OrientationCube {
public:
  explicit OrientationCube(vtkRenderer* followed);
  ~OrientationCube();

  void setTheme(const Theme& theme);
  void setShown(bool shown);
  vtkRenderer* renderer() const { return renderer_; }

private:
  void follow();

  vtkRenderer* followed_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkAnnotatedCubeActor> cube_;
  BeforeRender beforeRender_;
};

} // namespace viscera::scene
