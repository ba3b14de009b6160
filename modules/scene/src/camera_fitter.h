#pragma once

#include <functional>

#include "view_geometry.h"

class vtkRenderer;

namespace viscera::scene {

/// What a view shows wholly stays wholly in it where the view becomes narrower for its height, which would
/// cut off its sides, or a legend takes a part of it: the camera backs off as far as it has to (a parallel
/// one shows more), and comes back where there is room again. A camera that somebody else has moved since the
/// last frame is where it shall be, unless it was put for another shape (`put`).
///
/// It does so as a frame begins and at no event, although nothing that paints may change what a user has. The
/// size of the window, its density, the theme's type and the legend come from four sides, several of them
/// between two frames, and a session puts its camera before or after them. Only the frame has them together:
/// at each event the camera would back off for shapes that nobody sees, and that of a session for a legend
/// that it was saved with. Where the camera stands depends on where it was put and on the present shape
/// alone, not on the frames that were drawn, and where it was put is kept: drawing loses nothing.
class CameraFitter {
public:
  /// The room about its middle that a view has for what it shows, in heights of the view.
  struct Shape {
    double width = 0; ///< 0: there is none.
    double height = 1;
    bool operator==(const Shape& other) const = default;
  };

  /// Before each frame. `bounds` of what is shown are asked for where the view has another shape.
  void follow(vtkRenderer* renderer, const Shape& shape, const std::function<Bounds()>& bounds);
  /// The camera was put where it is for a view of this shape: has it another one in the next frame, as with a
  /// legend that comes in between, that counts as a change.
  void put(vtkRenderer* renderer, const Shape& shape);

private:
  ViewGeometry wished_; ///< The camera as other code has set it,
  Shape wishedShape_;   ///< and the view's shape at that time.
  ViewGeometry left_;   ///< The camera of the last frame.
  Shape shape_;
};

} // namespace viscera::scene
