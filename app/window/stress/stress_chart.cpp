#include "window/stress/stress_chart.h"

#include <QLabel>
#include <QStackedLayout>
#include <QTimer>
#include <QVBoxLayout>

#include <numbers>
#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "window/style/language.h"
#include "window/timeline/chart_cursor.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr double kDegrees = 180 / std::numbers::pi;
const Vec3 kMeanColor(0.31, 0.70, 0.75);
const Vec3 kPercentileColor(0.90, 0.66, 0.25);
const Vec3 kMaxColor(0.88, 0.36, 0.32);
const Vec3 kProbeColor(0.66, 0.47, 0.85);
} // namespace

StressChart::StressChart(StressModel& model, QWidget* parent)
    : QWidget(parent), model_(model), chart_(std::make_unique<scene::VolumeChart>()), hint_(new QLabel(this)),
      widget_(new QVTKOpenGLNativeWidget(this)), cursor_(new ChartCursor(*widget_)),
      stack_(new QStackedLayout) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  chart_->setDecimalMark(decimalMark());
  auto* column = makeLayout<QVBoxLayout>(this, -1, {8, 4, 8, 4});
  column->addLayout(stack_);
  hint_->setObjectName(QStringLiteral("muted"));
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  stack_->addWidget(hint_);
  stack_->addWidget(widget_);
  widget_->setMinimumSize(120, 72);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  widget_->setRenderWindow(window);
  chart_->setWindow(window);
  chart_->setAxes(tr("Time in the cycle").toStdString(), "s", tr("Rotational stress").toStdString(),
                  inWords("deg").toStdString());
  setLines();
  connect(&model, &StressModel::updated, this, &StressChart::refresh);
  connect(&model, &StressModel::probeChanged, this, &StressChart::refresh);
  connect(&model, &StressModel::instantChanged, this, &StressChart::placeCursor);
}

StressChart::~StressChart() {
  chart_->setWindow(nullptr);
}

void StressChart::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  chart_->setTheme(colors);
  cursor_->setColor(theme.text);
  refresh();
  draw();
}

void StressChart::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
  draw();
}

/// The cursor is placed when the chart is drawn at its new size.
void StressChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  QTimer::singleShot(0, this, &StressChart::draw);
}

void StressChart::refresh() {
  if (!isVisible())
    return;
  const bool otherProbe = std::exchange(probe_, model_.probe()) != model_.probe();
  const bool another = std::exchange(drawn_, model_.cycle()) != model_.cycle() || otherProbe;
  if (otherProbe)
    setLines();
  const Text& failure = model_.live().cycleMessage();
  hint_->setText(
      failure.empty()
          ? tr("The stress over one cycle of the sequence is drawn here as soon as it is computed.")
          : inWords(failure));
  stack_->setCurrentIndex(drawn_ ? 1 : 0);
  if (another) {
    drawCycle();
    draw();
  } else {
    placeCursor();
  }
}

/// The chosen point has a curve while there is one.
void StressChart::setLines() {
  std::vector<scene::ChartLine> lines = {{tr("maximum").toStdString(), kMaxColor},
                                         {tr("95th percentile").toStdString(), kPercentileColor},
                                         {tr("mean").toStdString(), kMeanColor}};
  if (probe_ >= 0)
    lines.push_back({tr("chosen point").toStdString(), kProbeColor});
  chart_->setLines(lines);
}

void StressChart::draw() {
  if (!isVisible())
    return;
  chart_->update();
  widget_->renderWindow()->Render();
  placeCursor();
}

/// A layer over the chart, which takes too long to be drawn for every frame.
void StressChart::placeCursor() {
  ChartCursor::Marks marks;
  if (const std::optional<double> fraction = model_.shownFraction(); drawn_ && fraction)
    if (const auto place = chart_->placeOf(*fraction * drawn_->periodSeconds))
      marks.lines.push_back({place->x, place->low, place->high});
  cursor_->setMarks(std::move(marks));
}

void StressChart::drawCycle() {
  chart_->clear();
  if (!drawn_)
    return;
  std::vector<double> seconds, largest, percentile, mean;
  for (const live::StressSample& sample : drawn_->closed()) {
    seconds.push_back(sample.seconds);
    largest.push_back(kDegrees * sample.statistics.max);
    percentile.push_back(kDegrees * sample.statistics.percentile95);
    mean.push_back(kDegrees * sample.statistics.mean);
  }
  chart_->setTimeRange({0, drawn_->periodSeconds});
  const auto gradients = model_.live().gradients();
  if (probe_ >= 0 && gradients && probe_ < gradients->witnesses() && !drawn_->poses.empty()) {
    std::vector<double> curve =
        live::curveAt(*gradients, probe_, *drawn_, live::StressQuantity::rotationalStress);
    curve.push_back(curve.front()); // The cycle's end is its beginning.
    chart_->setCurve(3, seconds, std::move(curve));
  }
  chart_->setCurve(0, seconds, std::move(largest));
  chart_->setCurve(1, seconds, std::move(percentile));
  chart_->setCurve(2, seconds, std::move(mean));
}

} // namespace viscera::app
