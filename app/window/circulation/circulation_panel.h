#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>

#include "viscera/scene/curve_panels.h"
#include "window/circulation/circulation_model.h"
#include "window/style/theme.h"
#include "window/timeline/volume_monitor.h"

class QLabel;

namespace viscera::app {

class NumbersTable;
class ViewModel;

/// A panel with the charts of the circulation: Wiggers's diagram over one beat with a cursor at the instant
/// that is shown, the pressure-volume loops of both ventricles with a mark at that instant, and their
/// numbers; dashed and in a column of its own what was kept to compare with.
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
  void draw();
  QString legendText() const;

  CirculationModel& model_;
  Playback& playback_;
  std::unique_ptr<scene::CurvePanels> panels_;
  QVTKOpenGLNativeWidget* chart_;
  NumbersTable* numbers_;
  QLabel* legend_;
  std::size_t panelCount_ = 0;
};

} // namespace viscera::app
