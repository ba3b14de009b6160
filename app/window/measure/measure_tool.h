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

/// Handles the mouse for measuring in the 3D view: while a kind is being measured every click on an organ is
/// a point, and the last one completes a measurement; else points that are there can be dragged along the
/// organs, which is one undo step. Nothing is in the document before a measurement is complete. The mouse on
/// slices comes by `SliceMeasuring`; rectangles and spheres are measured there alone.
class MeasureTool final : public QObject {
  Q_OBJECT

public:
  using Kind = document::MeasurementKind;

  /// All have to live longer.
  MeasureTool(Workspace& workspace, ViewWidget& view, const Picture& picture, const HandleController& handles,
              QObject* parent = nullptr);

  /// Measures again and again until `end`, or until the tool is no longer enabled.
  void begin(Kind kind);
  void end();
  bool active() const { return kind_.has_value(); }
  std::optional<Kind> kind() const { return kind_; }
  /// Whether there are points that are no measurement yet.
  bool begun() const { return !points_.empty(); }
  void setEnabled(bool enabled);
  bool enabled() const { return enabled_; }
  /// Takes back what the mouse is at: a drag, points that are no measurement yet, measuring, the choice.
  /// False when there was nothing.
  bool escape();

  /// The measurement that is chosen in the list or by a press on one of its points.
  document::MeasurementId chosen() const { return chosen_; }
  void choose(document::MeasurementId measurement);

  /// What is being measured, with the points so far and the place under the mouse behind them when there is
  /// one.
  document::Measurement pending() const;
  /// The mark under the mouse that a press would take hold of.
  std::optional<scene::MeasurementGlyphs::Mark> hovered() const { return hovered_; }
  void setHovered(const std::optional<scene::MeasurementGlyphs::Mark>& mark);

  /// A point of what is being measured; the last one completes it. `axis` is that of the slice that it is on,
  /// none for one on an organ. A rectangle begins anew in another slice.
  void add(const document::MeasuredPoint& point, std::optional<int> axis);
  /// What would be the next point; none: the mouse is on nothing.
  void setUnderMouse(const std::optional<document::MeasuredPoint>& point, std::optional<int> axis);
  /// Takes a point of the document into the hand; false when it is not there.
  bool hold(const scene::MeasurementGlyphs::Mark& mark);
  bool holding() const { return held_.has_value(); }
  /// Where the point in the hand is, mm; there has to be one.
  Vec3 placeHeld() const;
  void moveHeld(const document::MeasuredPoint& point);
  void letGo();

Q_SIGNALS:
  /// Measuring began or ended.
  void stateChanged();
  /// Something looks different, or something else is chosen.
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
  int axis_ = 2; ///< Of the slice that the points are on.
  std::optional<scene::MeasurementGlyphs::Mark> hovered_;
  std::optional<Held> held_;
  document::MeasurementId chosen_;
  Subscription subscription_;
};

} // namespace viscera::app
