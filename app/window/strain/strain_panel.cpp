#include "window/strain/strain_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "viscera/presentation/strain_figure.h"
#include "viscera/strain/aha_segments.h"
#include "window/strain/axis_picker.h"
#include "window/style/language.h"
#include "window/view/view_model.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/ready_made.h"
#include "window/work/actions.h"

namespace viscera::app {
namespace {

using live::StrainDirection;
using live::StrainMoment;

/// ms: during a drag the picture of the organs comes first.
constexpr int kStrainDelay = 30;
constexpr int kReferenceLetters = 14;
constexpr int kEyesStretch = 5, kCurvesStretch = 4;
constexpr double kLeftOfCurves = 64, kBelowCurves = 42; ///< Room of the axes' labels, pixels.

std::string strainWords(const std::string& english) {
  return english.empty() ? english : inWords(english).toStdString();
}

QVTKOpenGLNativeWidget* chartWidget(QWidget* parent, const char* name) {
  auto* widget = new QVTKOpenGLNativeWidget(parent);
  widget->setObjectName(QLatin1String(name));
  widget->setMinimumSize(160, 72);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  widget->setRenderWindow(window);
  return widget;
}

/// Rich text that names a curve by its colour.
QString markedBy(const Vec3& color, const QString& said) {
  return QStringLiteral("<span style=\"color:%1\">&#9632;</span>&nbsp;%2")
      .arg(QColor::fromRgbF(color.x(), color.y(), color.z()).name(), said.toHtmlEscaped());
}

} // namespace

QString nameOfSegment(int number) {
  const QString name = text(std::string(strain::segments()[static_cast<std::size_t>(number - 1)].name));
  QStringList words;
  for (const QString& word : name.split(QLatin1Char(' ')))
    words.push_back(inWords(word.toStdString()));
  return QStringLiteral("%1 %2").arg(number).arg(words.join(QLatin1Char(' ')));
}

StrainPanel::StrainPanel(const Parts& parts, const Actions& actions, QWidget* parent)
    : QWidget(parent), model_(parts.model), playback_(parts.playback), view_(parts.view),
      eyes_(std::make_unique<scene::BullsEyes>()), panels_(std::make_unique<scene::CurvePanels>()),
      eyesWidget_(chartWidget(this, "strainEyes")), chart_(chartWidget(this, "strainCurves")),
      cursor_(new ChartCursor(*chart_)), direction_(new QComboBox(this)), moment_(new QComboBox(this)),
      reference_(new QComboBox(this)),
      axes_(new AxisPicker(parts.model, parts.view, parts.picture, parts.widget, this)),
      numbers_(new QLabel(this)), segment_(new QLabel(this)), remarks_(makeRemark(QString(), this)) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  panels_->setDecimalMark(decimalMark());
  eyes_->setWindow(eyesWidget_->renderWindow());
  panels_->setWindow(chart_->renderWindow());
  auto* column = makeLayout<QVBoxLayout>(this, 2, {8, 4, 8, 4});
  column->addWidget(makeChoices(actions));
  for (const auto& [label, name] : {std::pair(numbers_, "strainNumbers"),
                                    std::pair(segment_, "strainSegment"), std::pair(remarks_, "muted")}) {
    label->setObjectName(QLatin1String(name));
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(label);
  }
  numbers_->setTextFormat(Qt::RichText);
  numbers_->setWordWrap(true);
  auto* row = makeLayout<QHBoxLayout>(nullptr, 8);
  row->addWidget(eyesWidget_, kEyesStretch);
  row->addWidget(chart_, kCurvesStretch);
  column->addLayout(row, 1);
  const QString definition =
      tr("GLS and GCS are the change of the length of contours of the endocardium, as ultrasound and feature "
         "tracking report it. GRS and the segments are the strain of the material at witness points of the "
         "wall. Shortening is negative. All are against the end of diastole. Values of single segments are "
         "poorly repeated between programs: hatched ones are not to be relied on.");
  for (QWidget* widget :
       {static_cast<QWidget*>(eyesWidget_), static_cast<QWidget*>(chart_), static_cast<QWidget*>(numbers_)})
    widget->setToolTip(definition);
  eyesWidget_->setMouseTracking(true);
  eyesWidget_->installEventFilter(this);
  chart_->installEventFilter(this);
  soon_.setSingleShot(true);
  soon_.setInterval(kStrainDelay);
  connect(&soon_, &QTimer::timeout, this, &StrainPanel::rebuild);
  connect(&parts.model, &StrainModel::changed, this, &StrainPanel::rebuildSoon);
  connect(axes_, &AxisPicker::pickingChanged, this, &StrainPanel::rebuildSoon);
  connect(&parts.view, &ViewModel::changed, this, &StrainPanel::followView);
  connect(&parts.playback, &Playback::advanced, this, &StrainPanel::followFrame);
  connect(&parts.playback, &Playback::stateChanged, this, &StrainPanel::followFrame);
  followView();
}

StrainPanel::~StrainPanel() {
  eyes_->setWindow(nullptr);
  panels_->setWindow(nullptr);
}

QWidget* StrainPanel::makeChoices(const Actions& actions) {
  auto* choices = new QWidget(this);
  auto* row = new FlowLayout(choices, 8); // Long words must not widen the window.
  for (const StrainDirection direction :
       {StrainDirection::longitudinal, StrainDirection::circumferential, StrainDirection::radial,
        StrainDirection::thickening}) // As the enumeration.
    direction_->addItem(inWords(std::string(presentation::titleOf(direction))));
  moment_->addItems({tr("Peak"), tr("At this instant"), tr("Time to peak")}); // As the enumeration.
  direction_->setObjectName(QStringLiteral("strainDirection"));
  moment_->setObjectName(QStringLiteral("strainMoment"));
  reference_->setObjectName(QStringLiteral("strainReference"));
  reference_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  reference_->setMinimumContentsLength(kReferenceLetters);
  reference_->addItem(tr("From the fullest phase"));
  for (QWidget* choice : {static_cast<QWidget*>(direction_), static_cast<QWidget*>(moment_),
                          static_cast<QWidget*>(reference_), static_cast<QWidget*>(axes_)})
    row->addWidget(choice);
  connect(direction_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    view_.change([index](presentation::ViewState& state) {
      state.strain.direction = static_cast<StrainDirection>(index);
    });
  });
  connect(moment_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    view_.change(
        [index](presentation::ViewState& state) { state.strain.moment = static_cast<StrainMoment>(index); });
  });
  connect(reference_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    view_.change([index](presentation::ViewState& state) { state.strain.reference = index; });
  });
  for (const char* id : {"play.strainOnOrgan", "play.exportStrain"})
    row->addWidget(makeActionButton(actions[id], choices));
  return choices;
}

void StrainPanel::setSecond(StrainModel* second) {
  if (second_)
    second_->disconnect(this);
  second_ = second;
  if (second)
    connect(second, &StrainModel::changed, this, &StrainPanel::rebuildSoon);
  rebuildSoon();
}

void StrainPanel::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  colors.accent = {theme.accent.redF(), theme.accent.greenF(), theme.accent.blueF()};
  eyes_->setTheme(colors);
  panels_->setTheme(colors);
  cursor_->setColor(theme.text);
  rebuildSoon();
}

bool StrainPanel::wanted() const {
  return view_.state().strain.chart && playback_.wantedPose() != live::WantedPose::rest;
}

void StrainPanel::followView() {
  const presentation::StrainLook look = view_.state().strain;
  const std::optional<presentation::StrainLook> before = std::exchange(look_, look);
  if (before == look)
    return; // A slice was moved, or another part of the view is another.
  const QSignalBlocker noDirection(direction_), noMoment(moment_);
  direction_->setCurrentIndex(static_cast<int>(look.direction));
  moment_->setCurrentIndex(static_cast<int>(look.moment));
  if (!before || before->chart != look.chart)
    Q_EMIT wantedChanged();
  rebuildSoon();
}

void StrainPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rebuildSoon();
}

bool StrainPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    rebuildSoon();
  if (watched == eyesWidget_) {
    if (event->type() == QEvent::MouseMove)
      hover(segmentAt(static_cast<QMouseEvent*>(event)->localPos()));
    if (event->type() == QEvent::Leave)
      hover(std::nullopt);
    if (event->type() == QEvent::MouseButtonPress)
      if (const auto segment = segmentAt(static_cast<QMouseEvent*>(event)->localPos()))
        view_.change([segment](presentation::ViewState& state) {
          state.strain.segment = state.strain.segment == *segment ? 0 : *segment;
        });
  }
  return QWidget::eventFilter(watched, event);
}

std::optional<int> StrainPanel::segmentAt(const QPointF& place) const {
  const double ratio = eyesWidget_->devicePixelRatioF();
  const auto hit = eyes_->at(ratio * place.x(), ratio * (eyesWidget_->height() - 1 - place.y()));
  return hit ? std::optional(static_cast<int>(hit->sector) + 1) : std::nullopt;
}

void StrainPanel::hover(std::optional<int> segment) {
  if (std::exchange(hovered_, segment) != segment)
    rebuildSoon();
}

void StrainPanel::rebuildSoon() {
  if (!soon_.isActive())
    soon_.start();
}

/// Draws the strain of a shown pose against rest, else that of the cycle as chosen.
std::optional<scene::BullsEyeFigure> StrainPanel::figureOf(const StrainModel& model) const {
  const presentation::StrainLook& look = view_.state().strain;
  const StrainModel::Reading pose = model.pose();
  if (!pose && !model.cycle())
    return std::nullopt;
  scene::BullsEyeFigure figure =
      pose ? presentation::strainBullsEye(*pose, look.direction, StrainMoment::instant, 1)
           : presentation::strainBullsEye(*model.cycle(), look.direction, look.moment, model.phaseNow());
  figure.selected = look.segment - 1;
  return figure;
}

void StrainPanel::rebuild() {
  if (!isVisible())
    return;
  const presentation::StrainLook& look = view_.state().strain;
  const bool both = second_ && model_.cycle() && second_->cycle();
  figures_.clear();
  if (const auto figure = figureOf(model_))
    figures_.push_back(*figure);
  if (const auto figure = second_ ? figureOf(*second_) : std::nullopt)
    figures_.push_back(*figure);
  if (both && !model_.pose())
    figures_.push_back(presentation::strainDifference(*model_.cycle(), *second_->cycle(), look.direction));
  for (scene::BullsEyeFigure& figure : figures_)
    presentation::translate(figure, strainWords);
  phase_ = model_.phaseNow();
  eyes_->setFigures(figures_);
  curves_ = model_.cycle()
                ? presentation::strainPanel(*model_.cycle(), hovered_.value_or(look.segment), look.direction)
                : scene::CurvePanel();
  if (both)
    for (scene::PanelCurve curve : presentation::strainPanel(*second_->cycle()).curves) {
      curve.dashed = true;
      curve.name.clear();
      curves_.curves.push_back(std::move(curve));
    }
  presentation::translate(curves_, strainWords);
  if (model_.cycle())
    curves_.xRange = scene::ValueRange{0, std::max(1e-3, model_.cycle()->strain.seconds.back())};
  makeRoom(curves_);
  panels_->setPanels(model_.cycle() ? std::vector{curves_} : std::vector<scene::CurvePanel>());
  syncReferences();
  numbers_->setText(numbersText());
  segment_->setText(segmentText());
  remarks_->setText(remarksText());
  remarks_->setVisible(!remarks_->text().isEmpty());
  eyesWidget_->setVisible(!figures_.empty());
  chart_->setVisible(model_.cycle() != nullptr);
  draw();
}

/// The axes get the room of their labels, however small the chart is; the numbers above it name the curves.
void StrainPanel::makeRoom(scene::CurvePanel& curves) const {
  curves.legend = false;
  curves.left = std::min(0.4, kLeftOfCurves / std::max(1, chart_->width()));
  curves.bottom = std::min(0.4, kBelowCurves / std::max(1, chart_->height()));
}

/// A bull's eye of an instant is drawn when another phase comes; the cursor follows each frame.
void StrainPanel::followFrame() {
  if (!isVisible())
    return;
  placeInstant();
  if (view_.state().strain.moment == StrainMoment::instant && model_.phaseNow() != phase_)
    rebuildSoon();
}

void StrainPanel::draw() {
  if (!figures_.empty()) {
    eyes_->update();
    eyesWidget_->renderWindow()->Render();
  }
  if (model_.cycle()) {
    panels_->update();
    chart_->renderWindow()->Render();
  }
  placeInstant();
}

void StrainPanel::placeInstant() {
  ChartCursor::Marks marks;
  if (model_.cycle() && model_.playing() && curves_.xRange) {
    const double part =
        (model_.secondsNow() - curves_.xRange->low) / (curves_.xRange->high - curves_.xRange->low);
    if (part >= 0 && part <= 1)
      marks.lines.push_back(
          {curves_.left + part * (curves_.right - curves_.left), curves_.bottom, curves_.top});
  }
  cursor_->setMarks(std::move(marks));
}

/// A phase that the present cycle does not have is not measured from.
void StrainPanel::syncReferences() {
  const int phases = model_.cycle() ? static_cast<int>(model_.cycle()->strain.seconds.size()) : 0;
  while (model_.cycle() && reference_->count() > phases + 1)
    reference_->removeItem(reference_->count() - 1);
  while (reference_->count() < phases + 1)
    reference_->addItem(tr("From phase %1").arg(reference_->count()));
  const int chosen = view_.state().strain.reference;
  reference_->setCurrentIndex(chosen < reference_->count() ? chosen : 0);
}

QString StrainPanel::numbersText() const {
  if (!model_.cycle())
    return {};
  QStringList parts;
  for (const presentation::GlobalStrain& global : presentation::globalStrains(*model_.cycle())) {
    const QString said = tr("%1 %2 % at %3 ms (healthy adults %4 to %5)")
                             .arg(text(global.name))
                             .arg(formatNumber(global.peakPercent, 1))
                             .arg(formatNumber(global.peakMs, 0))
                             .arg(formatNumber(global.healthyPercent.low, 1))
                             .arg(formatNumber(global.healthyPercent.high, 1));
    parts.push_back(markedBy(global.color, said));
  }
  parts += furtherNumbers();
  return parts.join(QStringLiteral("&nbsp;&nbsp; "));
}

/// Writes, as rich text, the numbers without a range: of the right ventricle and the atrium, of twist
/// and of the segments' times.
QStringList StrainPanel::furtherNumbers() const {
  const strain::HeartStrain& strain = model_.cycle()->strain;
  QStringList said;
  const auto add = [&](const char* name, const std::optional<strain::ContourStrain>& contour) {
    const QString title = inWords(std::string(name));
    const auto curve =
        std::find_if(curves_.curves.begin(), curves_.curves.end(),
                     [&title](const scene::PanelCurve& one) { return text(one.name) == title; });
    if (contour && curve != curves_.curves.end())
      said.push_back(markedBy(curve->color, QStringLiteral("%1 %2 %").arg(
                                                title, formatNumber(kPercent * contour->peak.value, 1))));
  };
  add("RV free wall", strain.rightFreeWall);
  add("Left atrium", strain.leftReservoir);
  const std::optional<double> twist = live::largestTurn(strain.twistDegrees),
                              torsion = live::largestTurn(strain.torsionDegreesPerCm);
  if (twist && torsion)
    said.push_back(QStringLiteral("%1 %2\u00b0 (%3\u00b0/cm)")
                       .arg(inWords(std::string("Twist")), formatNumber(*twist, 1), formatNumber(*torsion, 2))
                       .toHtmlEscaped());
  said.push_back(tr("Times to the peak differ by %1 ms along and %2 ms around")
                     .arg(formatNumber(kMsPerSecond * strain.dispersionLongitudinal, 0),
                          formatNumber(kMsPerSecond * strain.dispersionCircumferential, 0))
                     .toHtmlEscaped());
  return said;
}

/// The segment under the mouse, else the chosen one.
QString StrainPanel::segmentText() const {
  const int segment = hovered_.value_or(view_.state().strain.segment);
  if (segment < 1 || figures_.empty())
    return {};
  QStringList values;
  for (const scene::BullsEyeFigure& figure : figures_) {
    const auto& value = figure.sectors[static_cast<std::size_t>(segment - 1)].value;
    values.push_back(value ? QStringLiteral("%1 %2").arg(formatNumber(*value, 1), text(figure.unit))
                           : QStringLiteral("-"));
  }
  if (model_.cycle() && !model_.pose()) {
    if (const auto deviation =
            live::strainDeviation(*model_.cycle(), segment, view_.state().strain.direction))
      values.front() += QStringLiteral(" \u00b1 %1").arg(formatNumber(*deviation, 1));
    if (const auto wall = live::wallThickness(*model_.cycle(), segment))
      values.push_back(QStringLiteral("%1 mm, %2 %3 %")
                           .arg(formatNumber(wall->millimeters, 1),
                                inWords(std::string(presentation::titleOf(StrainDirection::thickening))),
                                formatNumber(wall->thickeningPercent, 0)));
  }
  return tr("%1: %2").arg(nameOfSegment(segment), values.join(listSeparator()));
}

QString StrainPanel::remarksText() const {
  if (axes_->picking())
    return QCoreApplication::translate("viscera::app::FitBox", "click the organ");
  if (!model_.failureReason().isEmpty())
    return model_.failureReason();
  if (!model_.cycle() && !model_.pose())
    return tr("The strain is drawn here as soon as it is measured.");
  QStringList remarks;
  if (model_.pose())
    remarks.push_back(tr("The bull's eye shows the present pose against rest."));
  if (model_.cycle() && !model_.pose())
    for (const Text& warning : model_.cycle()->warnings)
      remarks.push_back(asSentence(warning));
  return remarks.join(QLatin1Char(' '));
}

} // namespace viscera::app
