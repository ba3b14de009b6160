#include "window/stress/profile_chart.h"

#include <QEvent>
#include <QLocale>
#include <QVBoxLayout>

#include <array>
#include <cmath>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr int kProfileHeight = 170;
constexpr int kMostXTicks = 4, kMostYTicks = 4;
/// Pixels for the labels of the axes.
constexpr double kLeft = 52, kBottom = 40, kRight = 10, kTop = 10;
/// Told apart by readers who are colour-blind, on dark and light.
const std::array<Vec3, 4> kColors = {Vec3(0.31, 0.70, 0.75), Vec3(0.90, 0.66, 0.25), Vec3(0.80, 0.47, 0.65),
                                     Vec3(0.45, 0.55, 0.90)};

std::vector<scene::PanelCurve> curvesOf(const live::ReadProfile& read, const live::StressMeasure& measure,
                                        const Vec3& color) {
  std::vector<scene::PanelCurve> curves;
  bool joined = false;
  for (std::size_t i = 0; i < read.profile.mm.size(); ++i) {
    const double value = live::valueOf(read.profile.readings[i], measure);
    if (std::isfinite(value) && !joined)
      curves.push_back({curves.empty() ? read.name : std::string(), color, {}, {}});
    joined = std::isfinite(value);
    if (!joined)
      continue;
    curves.back().x.push_back(read.profile.mm[i]);
    curves.back().y.push_back(value);
  }
  return curves;
}

} // namespace

ProfileChart::ProfileChart(StressModel& model, QWidget* parent)
    : QWidget(parent), model_(model), panels_(std::make_unique<scene::CurvePanels>()),
      widget_(new QVTKOpenGLNativeWidget(this)) {
  setObjectName(QStringLiteral("profileChart"));
  setAccessibleName(tr("Profile along the line"));
  setFixedHeight(kProfileHeight);
  panels_->setDecimalMark(QLocale().decimalPoint().toLatin1());
  makeLayout<QVBoxLayout>(this, 0)->addWidget(widget_);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  widget_->setRenderWindow(window);
  panels_->setWindow(window);
  widget_->installEventFilter(this);
  hide();
}

ProfileChart::~ProfileChart() {
  panels_->setWindow(nullptr);
}

void ProfileChart::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  panels_->setTheme(colors);
  draw();
}

void ProfileChart::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw();
}

bool ProfileChart::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget_ && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &ProfileChart::draw, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void ProfileChart::refresh() {
  curves_.clear();
  std::size_t line = 0;
  for (const live::ReadProfile& read : model_.marks().profiles)
    for (scene::PanelCurve& curve : curvesOf(read, model_.look().measure(), kColors[line++ % kColors.size()]))
      curves_.push_back(std::move(curve));
  setVisible(!model_.marks().profiles.empty());
  draw();
}

void ProfileChart::draw() {
  if (!isVisible())
    return;
  const live::StressQuantityDescription& quantity = live::describe(model_.look().quantity);
  scene::CurvePanel panel;
  panel.xTitle = tr("Distance at rest (mm)").toStdString();
  panel.yTitle =
      (quantity.unit.empty() ? model_.title()
                             : tr("%1 (%2)").arg(model_.title(), inWords(model_.look().measure().unit())))
          .toStdString();
  panel.curves = curves_;
  panel.left = kLeft / std::max(1, widget_->width());
  panel.right = 1 - kRight / std::max(1, widget_->width());
  panel.bottom = kBottom / std::max(1, widget_->height());
  panel.top = 1 - kTop / std::max(1, widget_->height());
  double length = 0;
  for (const live::ReadProfile& read : model_.marks().profiles)
    length = std::max(length, read.profile.mm.back());
  panel.xRange = scene::ValueRange{0, std::max(length, 1e-6)};
  panel.mostXTicks = kMostXTicks;
  panel.mostYTicks = kMostYTicks;
  panel.legend = model_.marks().profiles.size() > 1;
  panels_->setPanels({std::move(panel)});
  panels_->update();
  widget_->renderWindow()->Render();
}

} // namespace viscera::app
