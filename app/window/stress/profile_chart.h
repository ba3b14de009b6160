#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <memory>

#include "viscera/scene/curve_panels.h"
#include "window/stress/stress_model.h"
#include "window/style/theme.h"

namespace viscera::app {

/// A chart of the displayed quantity along the lines between pinned probes, over the distance at rest; a
/// curve ends where its line leaves the tissue, and where tissue is folded. Visible only while there is a
/// line.
class ProfileChart final : public QWidget {
  Q_OBJECT

public:
  explicit ProfileChart(StressModel& model, QWidget* parent = nullptr);
  ~ProfileChart() override;

  void setTheme(const Theme& theme);
  /// What is drawn: a curve for each stretch of tissue, the first of a line with its name.
  const std::vector<scene::PanelCurve>& curves() const { return curves_; }

  /// Draws the values that the picture has interpolated.
  void refresh();

protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void draw();

  StressModel& model_;
  std::unique_ptr<scene::CurvePanels> panels_;
  QVTKOpenGLNativeWidget* widget_;
  std::vector<scene::PanelCurve> curves_;
};

} // namespace viscera::app
