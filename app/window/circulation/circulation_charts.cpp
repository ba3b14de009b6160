#include "window/circulation/circulation_charts.h"

#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "signs/circulation_texts.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {

CirculationCharts::CirculationCharts(CirculationModel& model, Playback& playback, VolumeMonitor& volumes,
                                     QWidget* parent)
    : QWidget(parent), model_(model), playback_(playback), panels_(std::make_unique<scene::CurvePanels>()),
      chart_(new QVTKOpenGLNativeWidget(this)), cursor_(new ChartCursor(*chart_)), legend_(new QLabel(this)) {
  panels_->setDecimalMark(decimalMark());
  auto* column = makeLayout<QVBoxLayout>(this, 2);
  legend_->setObjectName(QStringLiteral("circulationLegend"));
  legend_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  legend_->setTextFormat(Qt::RichText);
  legend_->setWordWrap(true);
  column->addWidget(legend_);
  column->addWidget(chart_, 1);
  chart_->setMinimumSize(240, 72);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  chart_->setRenderWindow(window);
  panels_->setWindow(window);
  chart_->installEventFilter(this);
  connect(&model, &CirculationModel::changed, this, &CirculationCharts::rebuild);
  connect(&volumes, &VolumeMonitor::shown, this, &CirculationCharts::placeInstant);
  connect(&playback, &Playback::stateChanged, this, &CirculationCharts::placeInstant);
}

CirculationCharts::~CirculationCharts() {
  panels_->setWindow(nullptr);
}

void CirculationCharts::setTheme(const Theme& theme) {
  theme_ = theme;
  cursor_->setColor(theme.text);
  rebuild();
}

void CirculationCharts::setSigns(const presentation::HeartSigns& signs) {
  if (std::exchange(signs_, signs) != signs)
    rebuild();
}

void CirculationCharts::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rebuild();
}

bool CirculationCharts::eventFilter(QObject* watched, QEvent* event) {
  if (watched == chart_ && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &CirculationCharts::rebuild, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void CirculationCharts::rebuild() {
  if (!isVisible())
    return;
  const int width = chart_->width(), height = chart_->height();
  scene::Theme colors = viewThemeOf(theme_);
  colors.typeScale = theme_.lecture ? presentation::stripTypeScale(width, height) : 1;
  if (!theme_.lecture)
    colors.panel = {theme_.panel.redF(), theme_.panel.greenF(), theme_.panel.blueF()};
  panels_->setTheme(colors);
  std::vector<scene::CurvePanel> panels;
  if (const CirculationModel::Shown* present = model_.present())
    panels = circulationPanels(*present, model_.kept(), {width, height, colors.typeScale, signs_}, wording());
  places_ = panels;
  for (scene::CurvePanel& place : places_)
    place.curves.clear();
  panels_->setPanels(std::move(panels));
  legend_->setText(circulationLegendText(model_.kept(), wording()));
  draw();
}

/// Where the heart is in the beat that is drawn; nowhere while another motion moves it, and where it could
/// not take the pose of the instant.
void CirculationCharts::placeInstant() {
  ChartCursor::Marks marks;
  const CirculationModel::Shown* present = model_.present();
  const bool posed = playback_.showing() && playback_.player().runner().obstacle().empty();
  if (present && posed && model_.isPlayed())
    marks = presentation::instantMarks(places_, *present, playback_.player().fraction());
  cursor_->setMarks(std::move(marks));
}

void CirculationCharts::draw() {
  placeInstant();
  panels_->update();
  chart_->renderWindow()->Render();
}

} // namespace viscera::app
