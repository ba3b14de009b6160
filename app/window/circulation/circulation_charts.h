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

/// The charts of the circulation: Wiggers's diagram over one beat with a cursor at the instant that is shown,
/// and the pressure-volume loops of both ventricles with a mark at that instant; above them the meaning of
/// their colours. A circulation kept for comparison is drawn dashed. Cursor and marks follow every frame; the
/// charts are drawn anew when the circulation, the room or what is chosen changes. In a lecture type and
/// lines are as large as the room allows.
class CirculationCharts final : public QWidget {
  Q_OBJECT

public:
  CirculationCharts(CirculationModel& model, Playback& playback, VolumeMonitor& volumes,
                    QWidget* parent = nullptr);
  ~CirculationCharts() override;

  void setTheme(const Theme& theme);
  /// Sets what is drawn, by default everything.
  void setSigns(const presentation::HeartSigns& signs);
  /// Draws the charts anew.
  void rebuild();

protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void placeInstant();
  void draw();

  CirculationModel& model_;
  Playback& playback_;
  std::unique_ptr<scene::CurvePanels> panels_;
  QVTKOpenGLNativeWidget* chart_;
  ChartCursor* cursor_;
  QLabel* legend_;
  Theme theme_;
  presentation::HeartSigns signs_;
  std::vector<scene::CurvePanel> places_; ///< The panels that are drawn, without their curves.
};

} // namespace viscera::app
