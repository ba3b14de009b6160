#pragma once

#include <functional>

#include "view_geometry.h"

class vtkRenderer;

namespace viscera::scene {

/// What a view shows wholly stays wholly in it where the view becomes narrower for its height, which would
/// cut off its sides, or a legend takes a part of the height: the camera backs off as far as it has to (a
/// parallel one shows more), and comes back where there is room again. A camera that somebody else has moved
/// since the last frame is where it shall be.
class SightKeeper {
public:
  /// The room that a view has for what it shows.
  struct Shape {
    double aspect = 0;     ///< Width over height; 0: there is none.
    double freeHeight = 1; ///< The part of the height, about the middle, that is free.
    bool operator==(const Shape& other) const = default;
  };

  /// Before each frame; `freeHeight` is the shape's. `bounds` of what is shown are asked for where the view
  /// has another shape.
  void follow(vtkRenderer* renderer, double freeHeight, const std::function<Bounds()>& bounds);

private:
  ViewGeometry wished_; ///< The camera as somebody else has put it,
  Shape wishedShape_;   ///< and the view's shape at that time.
  ViewGeometry left_;   ///< The same in the last frame.
  Shape shape_;
};

} // namespace viscera::scene
