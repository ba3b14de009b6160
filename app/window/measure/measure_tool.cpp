#include "window/measure/measure_tool.h"

#include <QMouseEvent>

#include <algorithm>
#include <utility>

#include "viscera/document/measurement_commands.h"

namespace viscera::app {
namespace {

/// Nearer points of a warped scan are the same place, found twice.
constexpr double kSamePlaceMm = 0.01;

/// Whether points are on surfaces that a document has, or on none.
bool areOn(const document::Document& document, const std::vector<document::MeasuredPoint>& points) {
  return std::all_of(points.begin(), points.end(), [&](const auto& point) {
    const auto organ = document.organ(point.organ);
    return !point.organ || (organ && point.triangle < organ->mesh->triangles.rows());
  });
}

} // namespace

MeasureTool::MeasureTool(Workspace& workspace, ViewWidget& view, const Picture& picture,
                         const HandleController& handles, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view), picture_(picture), handles_(handles) {
  view.installEventFilter(this);
  connect(&view, &ViewWidget::clicked, this, [this](const QPointF& place, Qt::KeyboardModifiers modifiers) {
    if (kind_ && !(modifiers & (Qt::ShiftModifier | Qt::ControlModifier)))
      onClick(place);
  });
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.organs()) { // The surface that points were clicked on may be gone or another one.
      points_.clear();
      underMouse_.reset();
    }
    const bool nothing = change.after.organs->empty() && !change.after.scan;
    if (nothing || (!change.after.scan && kind_ && document::isRegion(*kind_)))
      end();
    if (change.measurements())
      hovered_.reset();
  });
}

void MeasureTool::begin(Kind kind) {
  if (!enabled_ || kind_ == kind)
    return;
  kind_ = kind;
  points_.clear();
  underMouse_.reset();
  hovered_.reset();
  chosen_ = {};
  syncCursor();
  Q_EMIT stateChanged();
  Q_EMIT changed();
}

void MeasureTool::end() {
  if (!kind_)
    return;
  kind_.reset();
  points_.clear();
  underMouse_.reset();
  syncCursor();
  Q_EMIT stateChanged();
  Q_EMIT changed();
}

void MeasureTool::setEnabled(bool enabled) {
  enabled_ = enabled;
  if (enabled)
    return;
  if (held_)
    letGo();
  hovered_.reset();
  end();
  syncCursor();
}

bool MeasureTool::escape() {
  if (held_) {
    held_.reset(); // Which takes back what was dragged.
  } else if (!points_.empty()) {
    points_.clear();
  } else if (kind_) {
    end();
  } else if (chosen_) {
    chosen_ = {};
  } else {
    return false;
  }
  syncCursor();
  Q_EMIT changed();
  return true;
}

void MeasureTool::choose(document::MeasurementId measurement) {
  if (measurement == chosen_)
    return;
  chosen_ = measurement;
  Q_EMIT changed();
}

document::Measurement MeasureTool::pending() const {
  document::Measurement pending;
  if (!kind_)
    return pending;
  pending.kind = *kind_;
  pending.axis = axis_;
  pending.points = points_;
  if (underMouse_)
    pending.points.push_back(*underMouse_);
  if (!areOn(workspace_.document(), pending.points))
    pending.points.clear();
  if (pending.points.size() == 2 && *kind_ == Kind::rectangle)
    pending.points[1].rest[axis_] = pending.points[0].rest[axis_];
  return pending;
}

void MeasureTool::setHovered(const std::optional<scene::MeasurementGlyphs::Mark>& mark) {
  if (mark == hovered_)
    return;
  hovered_ = mark;
  syncCursor();
  Q_EMIT changed();
}

void MeasureTool::add(const document::MeasuredPoint& point, std::optional<int> axis) {
  if (!kind_ || (document::isRegion(*kind_) && !axis))
    return;
  if (*kind_ == Kind::rectangle && !points_.empty() &&
      (*axis != axis_ || point.rest[axis_] != points_.front().rest[axis_]))
    points_.clear();
  if (!points_.empty() && (points_.back().rest - point.rest).norm() < kSamePlaceMm)
    return; // The second click of two at one place: nothing lies between them.
  axis_ = axis.value_or(axis_);
  points_.push_back(point);
  underMouse_.reset();
  if (points_.size() == document::pointCount(*kind_))
    workspace_.perform(
        document::addMeasurement(document::Measurement{{}, {}, std::exchange(points_, {}), *kind_, axis_}));
  Q_EMIT changed();
}

void MeasureTool::setUnderMouse(const std::optional<document::MeasuredPoint>& point,
                                std::optional<int> axis) {
  underMouse_ = point;
  if (points_.empty())
    axis_ = axis.value_or(axis_);
  else if (point && kind_ == Kind::rectangle && axis != axis_)
    underMouse_.reset(); // In another slice than its first corner.
  Q_EMIT changed();
}

bool MeasureTool::hold(const scene::MeasurementGlyphs::Mark& mark) {
  const auto& measurements = workspace_.document().measurements();
  if (held_ || mark.item >= measurements.size() || mark.point >= measurements[mark.item].points.size())
    return false;
  if (measurements[mark.item].kind == Kind::gap) { // Its ends are where the organs are nearest.
    choose(measurements[mark.item].id);
    return false;
  }
  const document::MeasurementId id = measurements[mark.item].id;
  held_.emplace(Held{id, mark.point, {workspace_.undo(), "Move measured point"}});
  chosen_ = id;
  Q_EMIT changed();
  return true;
}

Vec3 MeasureTool::placeHeld() const {
  for (const document::Measurement& measurement : workspace_.document().measurements())
    if (measurement.id == held_->measurement)
      return measurement.points[held_->point].rest;
  return Vec3::Zero();
}

std::optional<Vec3> MeasureTool::regionStart() const {
  if (!held_) {
    const bool region = kind_ && document::isRegion(*kind_) && !points_.empty();
    return region ? std::optional(points_.front().rest) : std::nullopt;
  }
  for (const document::Measurement& measurement : workspace_.document().measurements())
    if (measurement.id == held_->measurement && document::isRegion(measurement.kind) && held_->point > 0)
      return measurement.points.front().rest;
  return std::nullopt;
}

void MeasureTool::moveHeld(const document::MeasuredPoint& point) {
  workspace_.perform(document::moveMeasuredPoint(held_->measurement, held_->point, point));
}

void MeasureTool::letGo() {
  auto held = std::exchange(held_, std::nullopt);
  held->step.finish();
  Q_EMIT changed();
}

bool MeasureTool::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &view_ || !enabled_)
    return false;
  switch (event->type()) {
  case QEvent::MouseButtonPress:
    return press(static_cast<QMouseEvent&>(*event));
  case QEvent::MouseMove:
    move(static_cast<QMouseEvent&>(*event));
    return held_.has_value();
  case QEvent::MouseButtonRelease:
    if (!held_)
      return false;
    letGo();
    return true;
  case QEvent::Leave:
    underMouse_.reset();
    hovered_.reset();
    Q_EMIT changed();
    return false;
  default:
    return false;
  }
}

void MeasureTool::onClick(const QPointF& place) {
  if (handles_.underMouse())
    return;
  if (const auto point = pointOf(view_.pickNear(place)))
    add(*point, std::nullopt);
}

/// While measuring, a press begins a click or turns the view, as ever.
bool MeasureTool::press(const QMouseEvent& event) {
  if (held_)
    return true; // Another button during a drag.
  if (kind_ || event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier ||
      handles_.underMouse())
    return false;
  const auto mark = markUnder(event.localPos());
  return mark && hold(*mark);
}

void MeasureTool::move(const QMouseEvent& event) {
  if (held_) {
    dragTo(event.localPos());
  } else if (kind_) {
    // While the view turns, what is under the mouse stays under it.
    setUnderMouse(event.buttons() || document::isRegion(*kind_) ? std::nullopt : pointUnder(event.localPos()),
                  std::nullopt);
  } else {
    setHovered(event.buttons() ? std::nullopt : markUnder(event.localPos()));
  }
}

void MeasureTool::dragTo(const QPointF& place) {
  if (const auto point = pointUnder(place))
    moveHeld(*point);
}

std::optional<document::MeasuredPoint>
MeasureTool::pointOf(const std::optional<scene::SurfacePick>& pick) const {
  const auto organ = pick ? workspace_.document().organ(picture_.organOf(pick->organ)) : nullptr;
  if (!organ)
    return std::nullopt;
  return document::surfacePoint(*organ, pick->triangle,
                                Vec3(pick->weights[0], pick->weights[1], pick->weights[2]));
}

std::optional<document::MeasuredPoint> MeasureTool::pointUnder(const QPointF& place) const {
  const double ratio = view_.devicePixelRatioF();
  return pointOf(view_.view().pick(ratio * place.x(), ratio * (view_.height() - 1 - place.y())));
}

std::optional<scene::MeasurementGlyphs::Mark> MeasureTool::markUnder(const QPointF& place) const {
  const double ratio = view_.devicePixelRatioF();
  const auto mark =
      picture_.presenter().measurements().markAt(ratio * place.x(), ratio * (view_.height() - 1 - place.y()));
  return mark && mark->item < workspace_.document().measurements().size() ? mark : std::nullopt;
}

void MeasureTool::syncCursor() {
  if (kind_)
    view_.setCursor(Qt::CrossCursor);
  else if (hovered_ || held_)
    view_.setCursor(Qt::PointingHandCursor);
  else
    view_.unsetCursor();
}

} // namespace viscera::app
