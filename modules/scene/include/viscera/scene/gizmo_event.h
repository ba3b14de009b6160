#pragma once

#include <functional>

#include "viscera/core/arrays.h"

class vtkVisceraGizmoWidget;

namespace viscera::scene {

/// What a gizmo's hand has done since it was grabbed (the call data of its events points to one of these):
/// a rotation, or a scaling.
struct GizmoEvent {
  bool rotates = false;        ///< Else it scales.
  Vec3 center = Vec3::Zero();  ///< What it turns or scales about, mm.
  Vec3 axis = Vec3::UnitX();   ///< Unit; of a rotation.
  double angle = 0;            ///< rad, of a rotation.
  Vec3 factors = Vec3::Ones(); ///< Along x, y and z, all above 0; of a scaling.
};

/// Calls `listener` for every event of that number (one of `vtkVisceraGizmoWidget`'s). Returns the observer's
/// tag for `RemoveObserver`. What the listener captures has to live as long as the widget or until it is
/// removed.
unsigned long observe(vtkVisceraGizmoWidget* widget, unsigned long event,
                      std::function<void(const GizmoEvent&)> listener);

} // namespace viscera::scene
