#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "viscera/core/arrays.h"

class vtkVisceraGizmoWidget;
class vtkVisceraHandleSetWidget;

namespace viscera::scene {

/// The data of a handle widget's events (the events' call data points to one of these).
struct HandleEvent {
  int handle = -1;              ///< The handle under the cursor or being dragged; -1: none.
  Vec3 position = Vec3::Zero(); ///< Where that handle is now, mm.
  Vec3 start = Vec3::Zero();    ///< Where it was when it was grabbed, mm.
  std::vector<int> moving; ///< During a drag every handle that moves with it, ascending; else the selection.
  /// The unit normal of the plane in which the mouse moves, that of a slice; none in a 3D view.
  std::optional<Vec3> plane = std::nullopt;
  Vec3 delta() const { return position - start; } ///< The same for every handle of `moving`.
};

/// The rotation or scaling of the gizmo since the user grabbed it (the call data of its events points to one
/// of these): a rotation, or a scaling.
struct GizmoEvent {
  bool rotates = false;        ///< Else it scales.
  Vec3 center = Vec3::Zero();  ///< What it turns or scales about, mm.
  Vec3 axis = Vec3::UnitX();   ///< Unit; of a rotation.
  double angle = 0;            ///< rad, of a rotation.
  Vec3 factors = Vec3::Ones(); ///< Along x, y and z, all above 0; of a scaling.
};

///@{
/// Calls `listener` for every event of that number (one of the widget's own). Returns the observer's tag for
/// `RemoveObserver`. What the listener captures has to live as long as the widget or until it is removed.
unsigned long observe(vtkVisceraHandleSetWidget* widget, unsigned long event,
                      std::function<void(const HandleEvent&)> listener);
unsigned long observe(vtkVisceraGizmoWidget* widget, unsigned long event,
                      std::function<void(const GizmoEvent&)> listener);
///@}

} // namespace viscera::scene
