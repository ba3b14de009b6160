#pragma once

#include <functional>

#include "view_geometry.h"

class vtkRenderer;

namespace viscera::scene {

/// What a view shows wholly stays wholly in it where the view becomes narrower for its height, which would
/// cut off its sides: the camera backs off as far as it has to (a parallel one shows more), and comes back
/// where there is room again. A camera that somebody else has moved since the last frame is where it shall
/// be.
class SightKeeper {
public:
  /// Before each frame. `bounds` of what is shown are asked for where the view has another shape.
  void follow(vtkRenderer* renderer, const std::function<Bounds()>& bounds);

private:
  ViewGeometry wished_;     ///< The camera as somebody else has put it,
  double wishedAspect_ = 0; ///< and width over height of the view at that time.
  ViewGeometry left_;       ///< The camera in the last frame, and the view's aspect; 0: before the first.
  double aspect_ = 0;
};

} // namespace viscera::scene
