#pragma once

#include <vtkNew.h>

#include "viscera/scene/theme.h"

#include "before_render.h"
#include "flat_shape.h"

class vtkAnnotatedCubeActor;
class vtkRenderer;

/// What stands in a corner or at an edge of every view.
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

/// A line of a round number of millimetres at the bottom of a view. With a perspective camera it is right in
/// the plane of the camera's focal point.
class ScaleBar {
public:
  explicit ScaleBar(vtkRenderer* renderer);
  ~ScaleBar();

  void setTheme(const Theme& theme);
  void setShown(bool shown);

private:
  void follow();

  FlatShape line_;
  vtkSmartPointer<vtkTextActor> text_;
  BeforeRender beforeRender_;
};

/// The longest length of 1, 2 or 5 times a power of ten that is at most `most` (> 0).
double roundLength(double most);

} // namespace viscera::scene
