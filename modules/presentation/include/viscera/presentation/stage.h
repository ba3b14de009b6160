#pragma once

#include <optional>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "viscera/presentation/presenter.h"
#include "viscera/scene/surfaceless_window.h"

namespace viscera::presentation {

/// Renders pictures of a document off the screen, for the command line and for movies. Belongs to the thread
/// that made it.
class Stage {
public:
  /// `width x height` device pixels, `pixelRatio` of them a logical one: type and lines grow with it. Throws
  /// `Error` when no OpenGL context can be created.
  Stage(int width, int height, const scene::Theme& theme, Threads threads = {},
        Presenter::Translate translate = {}, double pixelRatio = 1);
  ~Stage();

  Presenter& presenter() { return presenter_; }
  scene::OrganView& view() { return view_; }
  /// Moves the camera to a standard view of everything that is shown, with `room` around it as a fraction of
  /// its size. Frames the organs: handles that lie far off (the corners of an enclosing box) may be outside.
  void compose(scene::StandardView side, double room = 0);
  /// Renders the presenter's scene.
  vtkSmartPointer<vtkImageData> picture();

private:
  scene::SurfacelessWindow window_;
  scene::OrganView view_;
  Presenter presenter_;
};

} // namespace viscera::presentation
