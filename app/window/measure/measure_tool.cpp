#include "window/measure/measure_tool.h"

#include <QMouseEvent>

#include <algorithm>
#include <utility>

#include "viscera/document/measurement_commands.h"

namespace viscera::app {
namespace {

std::size_t pointsOf(document::MeasurementKind kind) {
  return kind == document::MeasurementKind::distance ? 2 : 3;
}

/// Whether points are on surfaces that a document has.
bool areOn(const document::Document& document, const std::vector<document::MeasuredPoint>& points) {
  return std::all_of(points.begin(), points.end(), [&](const auto& point) {
    const auto organ = document.organ(point.organ);
    return organ && point.triangle < organ->mesh->triangles.rows();
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
      if (change.after.organs->empty())
        end();
    }
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
    release();
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

std::vector<document::MeasuredPoint> MeasureTool::pending() const {
  std::vector<document::MeasuredPoint> points = points_;
  if (kind_ && underMouse_)
    points.push_back(*underMouse_);
  return areOn(workspace_.document(), points) ? points : std::vector<document::MeasuredPoint>();
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
    release();
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
  const auto point = pointOf(view_.pickNear(place));
  if (!point)
    return;
  points_.push_back(*point);
  if (points_.size() == pointsOf(*kind_)) {
    const auto points = std::exchange(points_, {});
    underMouse_.reset();
    workspace_.perform(document::addMeasurement(points));
  }
  Q_EMIT changed();
}

/// While measuring, a press begins a click or turns the view, as ever.
bool MeasureTool::press(const QMouseEvent& event) {
  if (held_)
    return true; // Another button during a drag.
  if (kind_ || event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier ||
      handles_.underMouse())
    return false;
  const auto mark = markUnder(event.localPos());
  if (!mark)
    return false;
  const document::Measurement& measurement = workspace_.document().measurements()[mark->item];
  held_.emplace(Held{measurement.id, mark->point, {workspace_.undo(), "Move measured point"}});
  chosen_ = measurement.id;
  Q_EMIT changed();
  return true;
}

void MeasureTool::move(const QMouseEvent& event) {
  if (held_) {
    dragTo(event.localPos());
  } else if (kind_) {
    // While the view turns, what is under the mouse stays under it.
    underMouse_ = event.buttons() ? std::nullopt : pointUnder(event.localPos());
    Q_EMIT changed();
  } else if (const auto mark = event.buttons() ? std::nullopt : markUnder(event.localPos());
             mark != hovered_) {
    hovered_ = mark;
    syncCursor();
    Q_EMIT changed();
  }
}

void MeasureTool::dragTo(const QPointF& place) {
  if (const auto point = pointUnder(place))
    workspace_.perform(document::moveMeasuredPoint(held_->measurement, held_->point, *point));
}

void MeasureTool::release() {
  auto held = std::exchange(held_, std::nullopt);
  held->step.finish();
  Q_EMIT changed();
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
