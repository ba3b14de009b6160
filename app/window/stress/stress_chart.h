#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>

#include "viscera/scene/volume_chart.h"
#include "window/stress/stress_model.h"
#include "window/style/theme.h"

class QLabel;
class QStackedLayout;

namespace viscera::app {

class ChartCursor;

/// A chart of the rotational stress over one whole cycle of a sequence: mean, 95th percentile, largest and
/// that of the chosen point as curves, with a cursor at the instant that is shown. The cursor follows every
/// frame; the chart is drawn anew when the cycle changes.
class StressChart final : public QWidget {
  Q_OBJECT

public:
  explicit StressChart(StressModel& model, QWidget* parent = nullptr);
  ~StressChart() override;

  void setTheme(const Theme& theme);
  /// The cycle that is drawn; null: a hint is shown instead.
  const std::shared_ptr<const live::CycleStress>& drawnCycle() const { return drawn_; }

protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void refresh();
  void setLines();
  void draw();
  void placeCursor();
  void drawCycle();

  StressModel& model_;
  std::unique_ptr<scene::VolumeChart> chart_;
  QLabel* hint_; ///< Why there is no chart yet.
  QVTKOpenGLNativeWidget* widget_;
  ChartCursor* cursor_;
  QStackedLayout* stack_; ///< The hint, or the chart.
  std::shared_ptr<const live::CycleStress> drawn_;
  int probe_ = -1; ///< The point of the mesh whose curve is drawn.
};

} // namespace viscera::app
