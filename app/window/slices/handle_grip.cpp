#include "window/slices/handle_grip.h"

#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/slices/slice_panes.h"
#include "window/view/picture.h"

namespace viscera::app {

bool HandleGrip::press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) {
  const int row = panes_.handleAt(direction, pixel);
  if (row < 0)
    return false;
  start_ = picture_.view().handles()->GetPosition(row);
  offset_ = panes_.frameNow(direction).pixelOf(start_) - pixel;
  picture_.view().handleWidget()->Grab(row, (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) != 0,
                                       panes_.normalOf(direction));
  return true;
}

/// The handle keeps its distance from the plane.
void HandleGrip::drag(int direction, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d middle = pixel + offset_;
  Vec3 place = panes_.frameNow(direction).at(middle.x(), middle.y());
  const Vec3 normal = panes_.normalOf(direction);
  place += normal.dot(start_ - place) * normal;
  picture_.view().handleWidget()->DragTo(place);
}

void HandleGrip::release(int, const Eigen::Vector2d&, bool) {
  picture_.view().handleWidget()->Drop();
}

std::optional<Qt::CursorShape> HandleGrip::hover(int direction, const std::optional<Eigen::Vector2d>& pixel) {
  auto* widget = picture_.view().handleWidget();
  const int row = pixel ? panes_.handleAt(direction, *pixel) : -1;
  if (!widget->IsDragging() && row != picture_.view().handles()->GetActiveHandle()) {
    widget->SetHovered(row);
    panes_.markOutdated();
  }
  return row >= 0 ? std::optional(Qt::PointingHandCursor) : std::nullopt;
}

} // namespace viscera::app
