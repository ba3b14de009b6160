#pragma once

#include <QWidget>

#include "window/circulation/circulation_charts.h"

namespace viscera::app {

class NumbersTable;
class ViewModel;

/// A panel with the charts of the circulation and their numbers, beside normal ranges. A circulation kept for
/// comparison has a column of its own.
class CirculationPanel final : public QWidget {
  Q_OBJECT

public:
  CirculationPanel(CirculationModel& model, Playback& playback, VolumeMonitor& volumes, ViewModel& view,
                   QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  /// Five strips below each other need more height than one chart.
  QSize sizeHint() const override { return {900, 320}; }

protected:
  void showEvent(QShowEvent* event) override;

private:
  void showNumbers();

  CirculationModel& model_;
  CirculationCharts* charts_;
  NumbersTable* numbers_;
};

} // namespace viscera::app
