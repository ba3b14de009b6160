#pragma once

#include <functional>

#include "view_geometry.h"

class vtkRenderer;

namespace viscera::scene {

/// Moves the camera back when a view becomes narrower or a legend takes a part of it, so that organs that
/// were fully visible stay so (a parallel camera shows more), and returns it when there is room again. Leaves
/// a camera alone that other code has moved since the last frame, unless it was set for another shape of the
/// view (`put`).
///
/// Runs when a frame begins, not at events: the window's size, its pixel density, the theme's type and the
/// legend change independently, several of them between two frames, and a session sets its camera before or
/// after them. Only the frame has the final shape; at each event the camera would move for shapes that are
/// never drawn. The position depends only on the camera that was set and on the present shape, not on the
/// frames drawn since, so drawing loses nothing.
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
  /// The camera was put where it is for a view of this shape: if the next frame has another
  /// shape, such as by a legend that appears in between, the camera is fitted to that.
  void put(vtkRenderer* renderer, const Shape& shape);

private:
  ViewGeometry set_;  ///< The camera as other code has set it,
  Shape setShape_;    ///< and the view's shape at that time.
  ViewGeometry left_; ///< The camera of the last frame.
  Shape shape_;
};

} // namespace viscera::scene
