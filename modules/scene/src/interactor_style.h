#pragma once

#include <vtkSmartPointer.h>

class vtkInteractorStyle;

namespace viscera::scene {

/// The mouse as in 3D Slicer: left rotates, middle or Shift+left pans, right drag or wheel zooms. VTK's
/// letter keys (quit, wireframe, stereo, pick) do nothing: keys belong to the window.
vtkSmartPointer<vtkInteractorStyle> newInteractorStyle();

} // namespace viscera::scene
