#include "window/stress/stress_chart.h"

#include <QLabel>
#include <QStackedLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <numbers>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "window/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr double kShownStressSeconds = 5; ///< Or a cycle and a half, which of a stomach's waves are longer.
constexpr double kShownCycles = 1.5;
constexpr double kDegrees = 180 / std::numbers::pi;
const Vec3 kMeanColor(0.31, 0.70, 0.75);
const Vec3 kPercentileColor(0.90, 0.66, 0.25);
const Vec3 kMaxColor(0.88, 0.36, 0.32);
} // namespace

StressChart::StressChart(StressModel& model, QWidget* parent)
    : QWidget(parent), model_(model), chart_(std::make_unique<scene::VolumeChart>()),
      widget_(new QVTKOpenGLNativeWidget(this)), stack_(new QStackedLayout) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  chart_->setDecimalMark(decimalMark());
  auto* column = makeLayout<QVBoxLayout>(this, -1, {8, 4, 8, 4});
  column->addLayout(stack_);
  auto* hint = new QLabel(tr("The stress over time is drawn here while a sequence plays (Space)."), this);
  hint->setObjectName(QStringLiteral("muted"));
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);
  stack_->addWidget(hint);
  stack_->addWidget(widget_);
  widget_->setMinimumSize(120, 72);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  widget_->setRenderWindow(window);
  chart_->setWindow(window);
  chart_->setAxes(tr("Time").toStdString(), "s", tr("Rotational stress").toStdString(),
                  inWords("deg").toStdString());
  chart_->setTimeSpan(kShownStressSeconds);
  chart_->setLines({{tr("largest").toStdString(), kMaxColor},
                    {tr("95th percentile").toStdString(), kPercentileColor},
                    {tr("mean").toStdString(), kMeanColor}});
  connect(&model, &StressModel::updated, this, &StressChart::refresh);
}

StressChart::~StressChart() {
  chart_->setWindow(nullptr);
}

void StressChart::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  chart_->setTheme(colors);
  refresh();
}

void StressChart::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void StressChart::refresh() {
  if (!isVisible())
    return;
  chart_->setTimeSpan(std::max(kShownStressSeconds, kShownCycles * model_.periodSeconds()));
  const auto& samples = model_.record().samples();
  stack_->setCurrentIndex(samples.size() < 2 ? 0 : 1);
  if (samples.empty() || samples.size() < charted_ || samples.back().seconds < chartedUntil_) {
    chart_->clear();
    charted_ = 0;
  }
  // The record drops its oldest samples when it is full: go by time.
  std::size_t row = samples.size();
  while (row > 0 && (charted_ == 0 || samples[row - 1].seconds > chartedUntil_))
    --row;
  for (; row < samples.size(); ++row) {
    const deformation::StressStatistics& statistics = samples[row].statistics;
    Values values(3);
    values << statistics.max, statistics.percentile95, statistics.mean;
    chart_->append(samples[row].seconds, kDegrees * values);
    chartedUntil_ = samples[row].seconds;
  }
  charted_ = samples.size();
  chart_->update();
  widget_->renderWindow()->Render();
}

} // namespace viscera::app
