#pragma once

#include <QObject>

#include <optional>
#include <vector>

#include "viscera/document/measurement.h"
#include "viscera/scene/measurement_glyphs.h"
#include "window/view/handle_controller.h"
#include "window/view/picture.h"
#include "window/view/view_widget.h"

namespace viscera::app {

/// Handles the mouse for measuring in the 3D view: while the user measures, every click on an organ adds a
/// point, and the last one completes the measurement; otherwise existing points can be dragged along the
/// organs, which is one undo step. A measurement is added to the document when it is complete.
/// `SliceMeasuring` handles the mouse on slices; rectangles and spheres can be measured there only.
class MeasureTool final : public QObject {
  Q_OBJECT

public:
  using Kind = document::MeasurementKind;

  /// All have to live longer.
  MeasureTool(Workspace& workspace, ViewWidget& view, const Picture& picture, const HandleController& handles,
              QObject* parent = nullptr);

  /// Begins to measure, one measurement after another, until `end` or until the tool is disabled.
  void begin(Kind kind);
  void end();
  bool active() const { return kind_.has_value(); }
  std::optional<Kind> kind() const { return kind_; }
  /// Whether the present measurement has points already but is incomplete.
  bool begun() const { return !points_.empty(); }
  void setEnabled(bool enabled);
  bool enabled() const { return enabled_; }
  /// Cancels the first of these that is under way: a drag, an incomplete measurement, measuring, the
  /// selection. False when there was nothing to cancel.
  bool escape();

  /// The measurement selected in the list or by a press on one of its points.
  document::MeasurementId chosen() const { return chosen_; }
  void choose(document::MeasurementId measurement);

  /// The measurement under way: its points so far, then the place under the mouse if there is one.
  document::Measurement pending() const;
  /// The mark under the mouse, which a press would grab.
  std::optional<scene::MeasurementGlyphs::Mark> hovered() const { return hovered_; }
  void setHovered(const std::optional<scene::MeasurementGlyphs::Mark>& mark);

  /// Adds a point to the measurement under way; the last one completes it. `axis` is that of the slice in
  /// which the point lies, none for a point on an organ. A rectangle begins anew in another slice.
  void add(const document::MeasuredPoint& point, std::optional<int> axis);
  /// Sets the place under the mouse, which would become the next point; none: there is nothing to measure
  /// there.
  void setUnderMouse(const std::optional<document::MeasuredPoint>& point, std::optional<int> axis);
  /// Grabs a point of a measurement in the document; false when it does not exist.
  bool hold(const scene::MeasurementGlyphs::Mark& mark);
  bool holding() const { return held_.has_value(); }
  /// The place at rest of the grabbed point, mm. Requires that a point is grabbed.
  Vec3 placeHeld() const;
  /// The place at rest of the first point of a region, by which all of it goes with the tissue (`placesNow`):
  /// of the one under way, or of the one whose other point is grabbed. None for the other kinds.
  std::optional<Vec3> regionStart() const;
  void moveHeld(const document::MeasuredPoint& point);
  void letGo();

Q_SIGNALS:
  /// Measuring began or ended.
  void stateChanged();
  /// The marks to draw or the selection have changed.
  void changed();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct Held {
    document::MeasurementId measurement;
    std::size_t point = 0;
    document::UndoStack::Step step;
  };

  void onClick(const QPointF& place);
  bool press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void dragTo(const QPointF& place);
  std::optional<document::MeasuredPoint> pointOf(const std::optional<scene::SurfacePick>& pick) const;
  std::optional<document::MeasuredPoint> pointUnder(const QPointF& place) const;
  std::optional<scene::MeasurementGlyphs::Mark> markUnder(const QPointF& place) const;
  void syncCursor();

  Workspace& workspace_;
  ViewWidget& view_;
  const Picture& picture_;
  const HandleController& handles_;
  bool enabled_ = false;
  std::optional<Kind> kind_;
  std::vector<document::MeasuredPoint> points_;
  std::optional<document::MeasuredPoint> underMouse_;
  int axis_ = 2; ///< Axis of the slice in which the points lie.
  std::optional<scene::MeasurementGlyphs::Mark> hovered_;
  std::optional<Held> held_;
  document::MeasurementId chosen_;
  Subscription subscription_;
};

} // namespace viscera::app
