#include "window/circulation/circulation_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "viscera/circulation/curves.h"
#include "viscera/heart/cardiac_times.h"
#include "window/circulation/numbers_table.h"
#include "window/language.h"
#include "window/timeline/person_box.h"
#include "window/view/view_model.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

using circulation::Compartment;

constexpr int kNumbersWidth = 372;
constexpr int kLoops = 2;

/// The sample at a part of the beat that is drawn.
std::size_t sampleAt(const CirculationModel::Shown& shown, double fraction) {
  const std::size_t count = shown.beat.time.size() - 1;
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count);
  return (circulation::firstDrawn(shown.parameters, shown.beat, heart::kBeforeAtria) +
          static_cast<std::size_t>(std::lround(place))) %
         count;
}

} // namespace

CirculationPanel::CirculationPanel(CirculationModel& model, Playback& playback, VolumeMonitor& volumes,
                                   ViewModel& view, QWidget* parent)
    : QWidget(parent), model_(model), playback_(playback), panels_(std::make_unique<scene::CurvePanels>()),
      chart_(new QVTKOpenGLNativeWidget(this)), cursor_(new ChartCursor(*chart_)),
      numbers_(new NumbersTable(this)), legend_(new QLabel(this)) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  panels_->setDecimalMark(decimalMark());
  auto* row = makeLayout<QHBoxLayout>(this, 8, {8, 4, 8, 4});
  auto* column = makeLayout<QVBoxLayout>(nullptr, 2);
  legend_->setObjectName(QStringLiteral("circulationLegend"));
  legend_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  legend_->setTextFormat(Qt::RichText);
  legend_->setWordWrap(true);
  column->addWidget(legend_);
  column->addWidget(chart_, 1);
  row->addLayout(column, 1);
  auto* numbers = makeLayout<QVBoxLayout>(nullptr, 2);
  numbers->addWidget(numbers_, 1);
  numbers->addWidget(new PersonBox(view, this));
  row->addLayout(numbers);
  numbers_->setFixedWidth(kNumbersWidth);
  chart_->setMinimumSize(240, 72);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  chart_->setRenderWindow(window);
  panels_->setWindow(window);
  chart_->installEventFilter(this);
  connect(&model, &CirculationModel::changed, this, &CirculationPanel::rebuild);
  connect(&view, &ViewModel::changed, this, [this, &view] {
    numbers_->setPerson(view.state().person);
    rebuild();
  });
  connect(&volumes, &VolumeMonitor::shown, this, &CirculationPanel::placeInstant);
  connect(&playback, &Playback::stateChanged, this, &CirculationPanel::placeInstant);
}

CirculationPanel::~CirculationPanel() {
  panels_->setWindow(nullptr);
}

void CirculationPanel::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  panels_->setTheme(colors);
  cursor_->setColor(theme.text);
  numbers_->setTheme(theme);
  rebuild();
}

void CirculationPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rebuild();
}

bool CirculationPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == chart_ && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &CirculationPanel::rebuild, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

QString CirculationPanel::legendText() const {
  QStringList parts;
  for (const presentation::CirculationLine& line : presentation::circulationLegend(model_.kept())) {
    const QColor color = QColor::fromRgbF(line.color.x(), line.color.y(), line.color.z());
    parts.push_back(QStringLiteral("<span style=\"color:%1\">%2</span>&nbsp;%3")
                        .arg(color.name(), line.dashed ? QStringLiteral("- -") : QStringLiteral("&#9632;"),
                             inWords(line.name).toHtmlEscaped()));
  }
  return parts.join(QStringLiteral("&nbsp;&nbsp; "));
}

void CirculationPanel::rebuild() {
  if (!isVisible())
    return;
  const CirculationModel::Shown* present = model_.present();
  const CirculationModel::Shown* kept = model_.kept();
  std::vector<scene::CurvePanel> panels;
  if (present)
    panels = presentation::circulationStrip(*present, kept, chart_->width(), chart_->height());
  for (scene::CurvePanel& panel : panels)
    for (std::string* title : {&panel.xTitle, &panel.yTitle})
      *title = inWords(*title).toStdString();
  places_ = panels;
  for (scene::CurvePanel& place : places_)
    place.curves.clear();
  panels_->setPanels(std::move(panels));
  numbers_->setIndices(present ? &present->indices : nullptr, kept ? &kept->indices : nullptr);
  legend_->setText(legendText());
  draw();
}

ChartCursor::Ring CirculationPanel::placeIn(const scene::CurvePanel& panel, double x, double y) {
  const auto between = [](double from, double to, const std::optional<scene::ValueRange>& range,
                          double value) {
    return range && range->high > range->low
               ? from + (to - from) * (value - range->low) / (range->high - range->low)
               : from;
  };
  return {between(panel.left, panel.right, panel.xRange, x),
          between(panel.bottom, panel.top, panel.yRange, y)};
}

/// Where the heart is in the beat that is drawn; nowhere while another motion moves it, and where it could
/// not take the pose of the instant.
void CirculationPanel::placeInstant() {
  ChartCursor::Marks marks;
  const CirculationModel::Shown* present = model_.present();
  const bool posed = playback_.showing() && playback_.player().runner().obstacle().empty();
  if (present && posed && model_.isPlayed() && places_.size() >= kLoops) {
    const double fraction = playback_.player().fraction();
    for (const scene::CurvePanel& panel : places_)
      if (panel.cursor)
        marks.lines.push_back(
            {placeIn(panel, fraction * present->beat.period, 0).x, panel.bottom, panel.top});
    const std::size_t sample = sampleAt(*present, fraction);
    std::size_t panel = places_.size() - kLoops;
    for (const Compartment ventricle : {Compartment::lv, Compartment::rv})
      marks.rings.push_back(placeIn(places_[panel++], present->beat.volumeOf(ventricle)[sample],
                                    present->beat.pressureOf(ventricle)[sample]));
  }
  cursor_->setMarks(std::move(marks));
}

void CirculationPanel::draw() {
  if (!isVisible())
    return;
  placeInstant();
  panels_->update();
  chart_->renderWindow()->Render();
}

} // namespace viscera::app
