#include "window/slices/handle_grip.h"

#include "viscera/medical_io/slice_frame.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/slices/slice_panes.h"
#include "window/view/picture.h"

namespace viscera::app {

bool HandleGrip::press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) {
  const int row = panes_.presenter().handleAt(direction, pixel, panes_.reach(direction));
  if (row < 0)
    return false;
  start_ = picture_.view().handles()->GetPosition(row);
  offset_ = panes_.presenter().frame(direction).pixelOf(start_) - pixel;
  const int axis = medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis;
  picture_.view().handleWidget()->Grab(row, (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) != 0,
                                       Vec3(Vec3::Unit(axis)));
  return true;
}

/// The handle keeps its distance from the plane.
void HandleGrip::drag(int direction, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d middle = pixel + offset_;
  Vec3 place = panes_.presenter().frame(direction).at(middle.x(), middle.y());
  const int axis = medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis;
  place[axis] = start_[axis];
  picture_.view().handleWidget()->DragTo(place);
}

void HandleGrip::release(int, const Eigen::Vector2d&, bool) {
  picture_.view().handleWidget()->Drop();
}

std::optional<Qt::CursorShape> HandleGrip::hover(int direction, const std::optional<Eigen::Vector2d>& pixel) {
  auto* widget = picture_.view().handleWidget();
  const int row = pixel ? panes_.presenter().handleAt(direction, *pixel, panes_.reach(direction)) : -1;
  if (!widget->IsDragging() && row != picture_.view().handles()->GetActiveHandle()) {
    widget->SetHovered(row);
    panes_.markOutdated();
  }
  return row >= 0 ? std::optional(Qt::PointingHandCursor) : std::nullopt;
}

} // namespace viscera::app
