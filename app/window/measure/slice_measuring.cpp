#include "window/measure/slice_measuring.h"

#include <cmath>

#include "viscera/medical_io/slice_frame.h"
#include "window/slices/slice_panes.h"

namespace viscera::app {
namespace {

/// Slices are farther apart; the warped scan's own accuracy is finer.
constexpr double kSameSliceMm = 0.1;

} // namespace

int SliceMeasuring::axisOf(int direction) {
  return medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis;
}

/// The point of the tissue that is drawn at a place. The other points of a region keep their distance from
/// its first one, by which it goes with the tissue.
document::MeasuredPoint SliceMeasuring::pointAt(const Vec3& place, int axis) const {
  document::MeasuredPoint point;
  point.rest = panes_.restOf(place);
  const auto start = tool_.regionStart();
  if (!start)
    return point;
  const Vec3 along = place - panes_.drawnAt(*start);
  const bool sameSlice = std::abs(along[axis]) < kSameSliceMm;
  if (!sameSlice && tool_.kind() == document::MeasurementKind::rectangle)
    return point; // It begins anew there.
  point.rest = *start + along;
  if (sameSlice)
    point.rest[axis] = (*start)[axis];
  return point;
}

document::MeasuredPoint SliceMeasuring::pointAt(int direction, const Eigen::Vector2d& pixel) const {
  return pointAt(panes_.frameNow(direction).at(pixel.x(), pixel.y()), axisOf(direction));
}

bool SliceMeasuring::measuresHere() const {
  return !panes_.cine().shown() || !tool_.active() || !document::isRegion(*tool_.kind());
}

bool SliceMeasuring::press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) {
  if (!tool_.enabled() || modifiers != Qt::NoModifier || !measuresHere())
    return false;
  if (tool_.active()) {
    tool_.add(pointAt(direction, pixel), axisOf(direction));
    drawing_ = tool_.begun();
    return true;
  }
  const auto mark = panes_.measuredAt(direction, pixel);
  if (!mark || !tool_.hold(*mark))
    return false;
  const auto first = tool_.regionStart();
  start_ =
      first ? Vec3(tool_.placeHeld() + (panes_.drawnAt(*first) - *first)) : panes_.drawnAt(tool_.placeHeld());
  offset_ = panes_.frameNow(direction).pixelOf(start_) - pixel;
  return true;
}

/// The point keeps its distance from the plane.
void SliceMeasuring::drag(int direction, const Eigen::Vector2d& pixel) {
  if (!tool_.holding())
    return tool_.setUnderMouse(pointAt(direction, pixel), axisOf(direction));
  Vec3 place = panes_.frameNow(direction).at((pixel + offset_).x(), (pixel + offset_).y());
  const Vec3 normal = panes_.normalOf(direction);
  place += normal.dot(start_ - place) * normal;
  tool_.moveHeld(pointAt(place, axisOf(direction)));
}

void SliceMeasuring::release(int direction, const Eigen::Vector2d& pixel, bool moved) {
  if (tool_.holding())
    tool_.letGo();
  else if (moved && drawing_)
    tool_.add(pointAt(direction, pixel), axisOf(direction));
}

std::optional<Qt::CursorShape> SliceMeasuring::hover(int direction,
                                                     const std::optional<Eigen::Vector2d>& pixel) {
  if (!tool_.enabled() || !measuresHere())
    return std::nullopt;
  if (tool_.active()) {
    tool_.setUnderMouse(pixel ? std::optional(pointAt(direction, *pixel)) : std::nullopt, axisOf(direction));
    return Qt::CrossCursor;
  }
  tool_.setHovered(pixel ? panes_.measuredAt(direction, *pixel) : std::nullopt);
  return tool_.hovered() ? std::optional(Qt::PointingHandCursor) : std::nullopt;
}

} // namespace viscera::app
