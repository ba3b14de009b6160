#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>
#include <vector>

#include "viscera/scene/curve_panels.h"
#include "window/circulation/circulation_model.h"
#include "window/style/theme.h"
#include "window/timeline/chart_cursor.h"
#include "window/timeline/volume_monitor.h"

class QLabel;

namespace viscera::app {

class NumbersTable;
class ViewModel;

/// A panel with the charts of the circulation: Wiggers's diagram over one beat with a cursor at the instant
/// that is shown, the pressure-volume loops of both ventricles with a mark at that instant, and their
/// numbers. A circulation kept for comparison is drawn dashed and has a column of its own. Cursor and marks
/// follow every frame; the charts are drawn anew when the circulation changes.
class CirculationPanel final : public QWidget {
  Q_OBJECT

public:
  CirculationPanel(CirculationModel& model, Playback& playback, VolumeMonitor& volumes, ViewModel& view,
                   QWidget* parent = nullptr);
  ~CirculationPanel() override;

  void setTheme(const Theme& theme);
  /// Five strips below each other need more height than one chart.
  QSize sizeHint() const override { return {900, 320}; }

protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void rebuild();
  void placeInstant();
  /// The place in the chart of a point in the axes of the panel.
  static ChartCursor::Ring placeIn(const scene::CurvePanel& panel, double x, double y);
  void draw();
  QString legendText() const;

  CirculationModel& model_;
  Playback& playback_;
  std::unique_ptr<scene::CurvePanels> panels_;
  QVTKOpenGLNativeWidget* chart_;
  ChartCursor* cursor_;
  NumbersTable* numbers_;
  QLabel* legend_;
  std::vector<scene::CurvePanel> places_; ///< The panels that are drawn, without their curves.
};

} // namespace viscera::app
