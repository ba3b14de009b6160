#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>

#include "viscera/scene/volume_chart.h"
#include "window/stress/stress_model.h"
#include "window/style/theme.h"

class QStackedLayout;

namespace viscera::app {

/// A chart of the rotational stress over the time of a sequence: mean, 95th percentile and largest, as
/// curves.
class StressChart final : public QWidget {
  Q_OBJECT

public:
  explicit StressChart(StressModel& model, QWidget* parent = nullptr);
  ~StressChart() override;

  void setTheme(const Theme& theme);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void refresh();

  StressModel& model_;
  std::unique_ptr<scene::VolumeChart> chart_;
  QVTKOpenGLNativeWidget* widget_;
  QStackedLayout* stack_; ///< A hint, or the chart.
  double chartedUntil_ = 0;
  std::size_t charted_ = 0;
};

} // namespace viscera::app
