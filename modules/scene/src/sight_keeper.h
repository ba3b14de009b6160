#pragma once

#include <functional>

#include "view_geometry.h"

class vtkRenderer;

namespace viscera::scene {

/// Moves the camera back when a view becomes narrower, or when a legend takes a part of its height, so that
/// organs that were wholly visible stay so (a parallel camera is scaled instead). The camera returns when
/// there is room again. If other code has moved the camera since the last frame, that camera is the new
/// reference.
class SightKeeper {
public:
  /// The shape of the free part of a view.
  struct Shape {
    double aspect = 0;     ///< Width over height; 0: there is none.
    double freeHeight = 1; ///< The part of the height, about the middle, that is free.
    bool operator==(const Shape& other) const = default;
  };

  /// Call it before each frame; `freeHeight` as in `Shape`. `bounds` is called for the box of what is shown
  /// if the shape of the view has changed.
  void follow(vtkRenderer* renderer, double freeHeight, const std::function<Bounds()>& bounds);

private:
  ViewGeometry wished_; ///< The camera as other code has set it,
  Shape wishedShape_;   ///< and the view's shape at that time.
  ViewGeometry left_;   ///< The camera of the last frame.
  Shape shape_;
};

} // namespace viscera::scene
