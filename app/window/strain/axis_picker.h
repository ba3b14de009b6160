#pragma once

#include <QToolButton>

#include <optional>
#include <vector>

#include "viscera/presentation/view_state.h"
#include "viscera/scene/measurement_glyphs.h"
#include "window/strain/strain_model.h"
#include "window/view/picture.h"
#include "window/view/view_widget.h"

namespace viscera::app {

class ViewModel;

/// A button whose menu sets the axes of a left ventricle by clicks on the organs: the middle of the mitral
/// ring, the apex, the anterior insertion of the right ventricle. Points that are not set are found. They
/// belong to the view, as the chosen segment does: a session keeps them. While the button is visible the view
/// shows the points that were set, and they move with the heart.
class AxisPicker final : public QToolButton {
  Q_OBJECT

public:
  AxisPicker(StrainModel& model, ViewModel& view, const Picture& picture, ViewWidget& widget,
             QWidget* parent = nullptr);
  ~AxisPicker() override;

  /// Whether the next click in the view sets a point.
  bool picking() const { return picking_ != nullptr; }
  /// The glyphs that show the points in the view.
  const scene::MeasurementGlyphs& glyphs() const { return glyphs_; }

Q_SIGNALS:
  void pickingChanged();

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  using Look = presentation::StrainLook;
  /// One point of the axes.
  struct Point {
    std::optional<Vec3> Look::*place;
    QAction* action;
  };

  void addPoint(const QString& name, const char* objectName, std::optional<Vec3> Look::*place);
  void pick(const Point* point);
  void onClick(const QPointF& place);
  void forget();
  void sync();
  void syncGlyphs();

  StrainModel& model_;
  ViewModel& viewModel_;
  const Picture& picture_;
  ViewWidget& widget_;
  std::vector<Point> points_;
  QAction* byShape_;
  const Point* picking_ = nullptr; ///< Of `points_`.
  scene::MeasurementGlyphs glyphs_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
