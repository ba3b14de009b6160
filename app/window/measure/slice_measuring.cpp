#include "window/measure/slice_measuring.h"

#include "viscera/medical_io/slice_frame.h"
#include "window/slices/slice_panes.h"

namespace viscera::app {

int SliceMeasuring::axisOf(int direction) {
  return medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis;
}

document::MeasuredPoint SliceMeasuring::pointAt(int direction, const Eigen::Vector2d& pixel) const {
  document::MeasuredPoint point;
  point.rest = panes_.presenter().frame(direction).at(pixel.x(), pixel.y());
  return point;
}

bool SliceMeasuring::press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) {
  if (!tool_.enabled() || modifiers != Qt::NoModifier)
    return false;
  if (tool_.active()) {
    tool_.add(pointAt(direction, pixel), axisOf(direction));
    drawing_ = tool_.begun();
    return true;
  }
  const auto mark = panes_.presenter().measuredAt(direction, pixel, panes_.reach(direction));
  if (!mark || !tool_.hold(*mark))
    return false;
  start_ = tool_.placeHeld();
  offset_ = panes_.presenter().frame(direction).pixelOf(start_) - pixel;
  return true;
}

/// The point keeps its distance from the plane.
void SliceMeasuring::drag(int direction, const Eigen::Vector2d& pixel) {
  if (!tool_.holding())
    return tool_.setUnderMouse(pointAt(direction, pixel), axisOf(direction));
  document::MeasuredPoint point = pointAt(direction, pixel + offset_);
  point.rest[axisOf(direction)] = start_[axisOf(direction)];
  tool_.moveHeld(point);
}

void SliceMeasuring::release(int direction, const Eigen::Vector2d& pixel, bool moved) {
  if (tool_.holding())
    tool_.letGo();
  else if (moved && drawing_)
    tool_.add(pointAt(direction, pixel), axisOf(direction));
}

std::optional<Qt::CursorShape> SliceMeasuring::hover(int direction,
                                                     const std::optional<Eigen::Vector2d>& pixel) {
  if (!tool_.enabled())
    return std::nullopt;
  if (tool_.active()) {
    tool_.setUnderMouse(pixel ? std::optional(pointAt(direction, *pixel)) : std::nullopt, axisOf(direction));
    return Qt::CrossCursor;
  }
  tool_.setHovered(pixel ? panes_.presenter().measuredAt(direction, *pixel, panes_.reach(direction))
                         : std::nullopt);
  return tool_.hovered() ? std::optional(Qt::PointingHandCursor) : std::nullopt;
}

} // namespace viscera::app
