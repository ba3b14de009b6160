#include "window/timeline/volume_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedLayout>
#include <QTabBar>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "viscera/heart/clinical_numbers.h"
#include "window/style/language.h"
#include "window/timeline/chart_cursor.h"
#include "window/timeline/measured_motion.h"
#include "window/timeline/person_box.h"
#include "window/view/view_model.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/panel_dock.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr double kShownVolumeSeconds = 5;
/// What the axis of drags shows, s: the least of these that has all of them, or the last one.
constexpr double kShownDragSeconds[] = {1, 2, 5, 12};
constexpr int kLeastTileWidth = 148;
constexpr int kTileMargin = 4;
constexpr int kTileGap = 8; ///< Between two columns.
constexpr int kLineSwatch = 10;
constexpr double kEndMark = 0.12;       ///< Of the chart's height, for the ends of diastole and systole.
constexpr int kVolumeChartHeight = 160; ///< Below the tabs.
enum { kChartTab, kTableTab };

using Quantity = heart::NormalRange::Quantity;

bool inMilliliters(const heart::NormalRange& range) {
  return range.quantity != Quantity::ejectionPercent;
}

/// The axis is as long as what went by: half a second at the end of twelve empty ones would say little.
double spanOf(double seconds) {
  const double* span = std::lower_bound(std::begin(kShownDragSeconds), std::end(kShownDragSeconds), seconds);
  return span == std::end(kShownDragSeconds) ? *std::rbegin(kShownDragSeconds) : *span;
}

QIcon swatch(const Vec3& color) {
  QPixmap pixmap(kLineSwatch, kLineSwatch);
  pixmap.fill(QColor::fromRgbF(color.x(), color.y(), color.z()));
  return pixmap;
}

QString rangeText(const heart::NormalRange& range) {
  return QStringLiteral("%1\u2013%2").arg(formatNumber(range.low, 0)).arg(formatNumber(range.high, 0));
}

/// "Petersen 2017 (UK Biobank)", without where it is to be found.
QString shortSource(const QString& source) {
  return source.left(source.indexOf(QLatin1String(", doi")));
}

/// Short enough to stand in the chart.
QString shortName(const heart::NormalRange& range) {
  switch (range.quantity) {
  case Quantity::endDiastolicMl:
    return VolumePanel::tr("normal at the end of diastole");
  case Quantity::endSystolicMl:
    return VolumePanel::tr("normal at the end of systole");
  default:
    return VolumePanel::tr("normal %1").arg(inWords(range.name));
  }
}

bool hasNormals(const VolumeMonitor::Line& line) {
  return !heart::normalRanges(line.label).empty();
}

/// ms: the picture of the organs is drawn first, because the chart takes as long as that.
constexpr int kDelay = 40;

} // namespace

VolumePanel::VolumePanel(VolumeMonitor& monitor, Playback& playback, ViewModel& view, QWidget* parent)
    : QWidget(parent), monitor_(monitor), playback_(playback), view_(view),
      chart_(std::make_unique<scene::VolumeChart>()), chartWidget_(new QVTKOpenGLNativeWidget(this)),
      cursor_(new ChartCursor(*chartWidget_)), tabs_(new QTabBar(this)), chartTab_(new QWidget(this)),
      stack_(new QStackedLayout), tileArea_(new QWidget(this)) {
  person_ = view.state().person;
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  chart_->setDecimalMark(decimalMark());
  auto* row = makeLayout<QHBoxLayout>(this, 8, {0, 4, 8, 4});
  row->addWidget(makeTiles());
  column_ = makeLayout<QVBoxLayout>(nullptr, 0);
  tabs_->setObjectName(QStringLiteral("chartTabs"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->addTab(tr("Chart"));
  tabs_->hide();
  column_->addWidget(tabs_);
  column_->addWidget(chartTab_, 1);
  auto* chart = makeLayout<QVBoxLayout>(chartTab_, 0);
  chart->addLayout(stack_, 1);
  normals_ = new QWidget(this);
  auto* normals = makeLayout<QHBoxLayout>(normals_, 8);
  source_ = new ElidedLabel(this);
  source_->setObjectName(QStringLiteral("chartSource"));
  normals->addWidget(source_, 1);
  normals->addWidget(new PersonBox(view, this));
  chart->addWidget(normals_);
  row->addLayout(column_, 1);
  makeChart();
  connect(&monitor, &VolumeMonitor::linesChanged, this, &VolumePanel::rebuild);
  connect(&monitor, &VolumeMonitor::chosenChanged, this, &VolumePanel::showNormalsOfChosen);
  connect(&monitor, &VolumeMonitor::shown, this, &VolumePanel::followFrame);
  connect(&monitor, &VolumeMonitor::updated, this, &VolumePanel::refreshIfNew);
  connect(&playback, &Playback::stateChanged, this, &VolumePanel::syncPrescribed);
  connect(&view, &ViewModel::changed, this, [this] {
    if (std::exchange(person_, view_.state().person) == person_)
      return;
    syncNormals();
    refresh();
  });
  rebuild();
}

QWidget* VolumePanel::makeTiles() {
  new QVBoxLayout(tileArea_);
  tileArea_->layout()->setContentsMargins(2 * kTileMargin, 0, 0, 0);
  QWidget* scroll = scrolled(tileArea_);
  const int bar = static_cast<QScrollArea*>(scroll)->verticalScrollBar()->sizeHint().width();
  scroll->setFixedWidth(2 * tileWidth() + kTileGap + 4 * kTileMargin + bar);
  return scroll;
}

int VolumePanel::tileWidth() const {
  constexpr double kWidePercent = 1000, kWideMl = 1000;
  const QString change = tr("%1 % of rest").arg(formatNumber(kWidePercent, 1));
  const QString beat = tr("EF %1 %  SV %2 ml").arg(formatNumber(kPercent, 0)).arg(formatNumber(kWideMl, 0));
  return std::max(
      {kLeastTileWidth, fontMetrics().horizontalAdvance(change), fontMetrics().horizontalAdvance(beat)});
}

void VolumePanel::makeChart() {
  auto* hint = new QLabel(
      tr("Volumes over time are drawn here while a sequence plays (Space) or handles are dragged (3)."),
      this);
  hint->setObjectName(QStringLiteral("muted"));
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);
  stack_->addWidget(hint);
  stack_->addWidget(chartWidget_);
  chartWidget_->setMinimumSize(120, 72);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  chartWidget_->setRenderWindow(window);
  chart_->setWindow(window);
  drawing_.setSingleShot(true);
  drawing_.setInterval(kDelay);
  connect(&drawing_, &QTimer::timeout, this, &VolumePanel::draw);
}

VolumePanel::~VolumePanel() {
  chart_->setWindow(nullptr);
}

void VolumePanel::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  chart_->setTheme(colors);
  cursor_->setColor(theme.text);
  refresh();
}

void VolumePanel::setCycleShown(bool shown) {
  if (shown == cycleShown_)
    return;
  cycleShown_ = shown;
  chart_->clear();
  charted_ = 0;
  refresh();
}

void VolumePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

/// The cursor is placed when the chart is drawn at its new size.
void VolumePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!drawing_.isActive())
    drawing_.start();
}

void VolumePanel::rebuild() {
  delete tileBox_;
  tiles_.clear();
  tileBox_ = new QWidget(tileArea_);
  auto* grid = makeLayout<QGridLayout>(tileBox_, -1, {kTileMargin, 0, kTileMargin, 0});
  grid->setHorizontalSpacing(kTileGap);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(2, 1); // Tiles keep their width in a wider box.
  std::vector<scene::ChartLine> lines;
  const auto isCavity = [](const VolumeMonitor::Line& line) { return line.cavity; };
  const bool cavities = std::any_of(monitor_.lines().begin(), monitor_.lines().end(), isCavity);
  for (const VolumeMonitor::Line& line : monitor_.lines()) {
    tiles_.push_back(addTile(line));
    // A whole organ is so much larger than its cavities that on one axis neither would be seen to move.
    const bool right = cavities && !line.cavity;
    const QString name = right ? tr("%1 (right axis)").arg(monitor_.nameOf(line)) : monitor_.nameOf(line);
    lines.push_back({name.toStdString(), line.color, {}, right, line.side == 1});
  }
  dots_.clear();
  for (std::size_t line = 0; measured_ && line < monitor_.lines().size(); ++line)
    if (const auto surface = monitor_.lines()[line].side == 0
                                 ? measured_->surfaceOf(monitor_.lines()[line].organ)
                                 : std::nullopt) {
      dots_.push_back({line, *surface, false});
      scene::ChartLine dots = lines[line];
      dots.name = tr("%1 measured").arg(monitor_.lines()[line].name).toStdString();
      dots.dots = true;
      lines.push_back(dots);
      if (const auto before = measured_->surfaceBefore(*surface)) {
        dots_.push_back({line, *before, true});
        dots.name = tr("%1 before").arg(monitor_.lines()[line].name).toStdString();
        dots.dots = false;
        dots.dashed = true;
        lines.push_back(dots);
      }
    }
  prescribed_ = prescribedLine();
  if (prescribed_ < monitor_.lines().size()) {
    const std::string name =
        tr("%1 prescribed").arg(monitor_.nameOf(monitor_.lines()[prescribed_])).toStdString();
    lines.push_back({name, lines[prescribed_].color, {}, lines[prescribed_].rightAxis, true});
  }
  if (tiles_.empty()) {
    auto* hint = makeRemark(tr("Closed organs show their volume here."), tileBox_);
    grid->addWidget(hint, 0, 0);
  }
  if (monitor_.unlisted() > 0)
    grid->addWidget(makeRemark(tr("%n more organs are not drawn: choose one to see its volume.", nullptr,
                                  monitor_.unlisted()),
                               tileBox_),
                    grid->rowCount(), 0, 1, 2);
  grid->setRowStretch(grid->rowCount(), 1);
  static_cast<QVBoxLayout*>(tileArea_->layout())->addWidget(tileBox_);
  tileBox_->show();
  chart_->setLines(lines);
  charted_ = 0;
  const auto first = std::find_if(monitor_.lines().begin(), monitor_.lines().end(), hasNormals);
  normalsOf_ = static_cast<std::size_t>(first - monitor_.lines().begin());
  syncNormals();
  refresh();
  showNormalsOfChosen();
}

void VolumePanel::showNormalsOfChosen() {
  const std::size_t line = monitor_.chosenLine();
  if (line != normalsOf_ && line < monitor_.lines().size() && hasNormals(monitor_.lines()[line]))
    setNormalsOf(line);
}

/// The line of the first view whose volume is prescribed; behind the last one when none is.
std::size_t VolumePanel::prescribedLine() const {
  const auto& volume = playback_.player().runner().prescribed();
  const auto& lines = monitor_.lines();
  const auto isIt = [&](const VolumeMonitor::Line& line) {
    return volume && line.side == 0 && line.organ == volume->organ;
  };
  return static_cast<std::size_t>(std::find_if(lines.begin(), lines.end(), isIt) - lines.begin());
}

void VolumePanel::syncPrescribed() {
  prescribedLine() == prescribed_ ? refresh() : rebuild();
}

/// The target lies under the curve of its organ, which is the last one of the chart.
void VolumePanel::drawPrescribed(double length) {
  const auto& volume = playback_.player().runner().prescribed();
  if (!volume || chart_->lineCount() == static_cast<int>(tiles_.size() + dots_.size()))
    return;
  std::vector<double> times, milliliters;
  for (int i = 0; i <= kPercent; ++i) {
    times.push_back(length * i / kPercent);
    milliliters.push_back(volume->milliliters.at(i / kPercent));
  }
  chart_->setCurve(chart_->lineCount() - 1, std::move(times), std::move(milliliters));
}

void VolumePanel::setMeasured(MeasuredMotion& measured, QWidget* table) {
  measured_ = &measured;
  table_ = table;
  column_->addWidget(table, 1);
  tabs_->addTab(tr("Fit of the motion"));
  connect(tabs_, &QTabBar::currentChanged, this, &VolumePanel::showTab);
  connect(&measured, &MeasuredMotion::changed, this, &VolumePanel::rebuild);
  connect(&measured, &MeasuredMotion::changed, this, &VolumePanel::syncMeasured);
  connect(&playback_, &Playback::stateChanged, this, &VolumePanel::syncMeasured);
  table->hide();
}

/// The table belongs to the sequence: it is there where that is looked at, also at rest, as after an undo.
void VolumePanel::syncMeasured() {
  const bool wanted = measured_->present() && playback_.wantedPose() == live::WantedPose::sequence;
  if (wanted == !tabs_->isHidden())
    return;
  tabs_->setVisible(wanted);
  tabs_->setCurrentIndex(wanted ? kTableTab : kChartTab);
  showTab(tabs_->currentIndex());
  Q_EMIT wantedHeightChanged();
}

void VolumePanel::showTab(int tab) {
  chartTab_->setVisible(tab == kChartTab);
  table_->setVisible(tab == kTableTab);
  refresh();
}

std::optional<int> VolumePanel::wantedHeight() const {
  if (tabs_->isHidden())
    return std::nullopt;
  return tabs_->sizeHint().height() + std::max(kVolumeChartHeight, table_->sizeHint().height());
}

/// Measured volumes stand at their phases; those of the series before at the same part of the cycle.
void VolumePanel::drawMeasured(double length) {
  if (!measured_ || !measured_->present())
    return;
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    const MeasuredMotion::Found* found = dots_[i].before ? measured_->before() : measured_->present();
    const tracking::PhaseTimes& phases = found->series->times;
    std::vector<double> times, milliliters;
    for (std::size_t phase = 0; phase < phases.count(); ++phase) {
      if (!dots_[i].before && found->images && !found->images->found.isLabelled(phase))
        continue; // Nobody measured it.
      times.push_back(length * phases.seconds[phase] / phases.periodSeconds);
      milliliters.push_back(found->series->volumesMl[phase][dots_[i].surface]);
    }
    if (dots_[i].before && phases.loop) { // The line goes on to where it begins.
      times.push_back(length);
      milliliters.push_back(milliliters.front());
    }
    chart_->setCurve(static_cast<int>(tiles_.size() + i), std::move(times), std::move(milliliters));
  }
}

/// The last of an odd number has the whole row, its detail in the second column: alone at the left it would
/// look as if one were missing.
VolumePanel::Tile VolumePanel::addTile(const VolumeMonitor::Line& line) {
  auto* grid = static_cast<QGridLayout*>(tileBox_->layout());
  const int index = static_cast<int>(tiles_.size());
  const bool wholeRow = index % 2 == 0 && tiles_.size() + 1 == monitor_.lines().size();
  const int width = wholeRow ? 2 * tileWidth() + kTileGap : tileWidth();
  const QString called = monitor_.nameOf(line);
  auto* box = new QWidget(tileBox_);
  auto* parts = makeLayout<QGridLayout>(box, 0);
  parts->setHorizontalSpacing(kTileGap);
  auto* name = new QToolButton(box);
  name->setObjectName(QStringLiteral("tileName"));
  // A long name must not push the second column out of sight.
  box->setFixedWidth(width);
  name->setText(name->fontMetrics().elidedText(called, Qt::ElideRight, width - 2 * kLineSwatch - 8));
  name->setIcon(swatch(line.color));
  name->setIconSize(QSize(kLineSwatch, kLineSwatch));
  name->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  name->setToolTip(tr("%1: show its normal range in the chart").arg(called));
  connect(name, &QToolButton::clicked, this,
          [this, index] { setNormalsOf(static_cast<std::size_t>(index)); });
  Tile tile{new QLabel(box), new QLabel(box)};
  embolden(tile.value, 1.25);
  tile.value->setObjectName(QStringLiteral("tileValue"));
  tile.detail->setObjectName(QStringLiteral("muted"));
  for (QLabel* label : {tile.value, tile.detail}) { // Another number in every frame lays out nothing anew.
    label->ensurePolished();
    label->setFixedSize(tileWidth(), label->sizeHint().height());
  }
  parts->addWidget(name, 0, 0, 1, wholeRow ? 2 : 1);
  parts->addWidget(tile.value, 1, 0);
  parts->addWidget(tile.detail, wholeRow ? 1 : 2, wholeRow ? 1 : 0);
  grid->addWidget(box, index / 2, index % 2, 1, wholeRow ? 2 : 1);
  return tile;
}

void VolumePanel::setNormalsOf(std::size_t line) {
  normalsOf_ = line;
  syncNormals();
  refresh();
}

void VolumePanel::syncNormals() {
  const bool any = normalsOf_ < monitor_.lines().size();
  normalsBeat_ = any && monitor_.beats(normalsOf_);
  for (std::size_t line = 0; line < monitor_.lines().size(); ++line) {
    std::vector<scene::ChartBand> bands;
    if (line == normalsOf_)
      for (const heart::NormalRange& range : monitor_.normals(line, person_))
        if (inMilliliters(range))
          bands.push_back({{range.low, range.high}, shortName(range).toStdString()});
    chart_->setBands(static_cast<int>(line), std::move(bands));
  }
  const QStringList forms = normalsForms();
  source_->setFullText(forms.value(0), forms.mid(1));
}

QString VolumePanel::normalsText() const {
  return normalsForms().value(0);
}

/// Forms from all that is known to the name of the source.
QStringList VolumePanel::normalsForms() const {
  if (normalsOf_ >= monitor_.lines().size())
    return {};
  const VolumeMonitor::Line& line = monitor_.lines()[normalsOf_];
  QStringList parts;
  QString from, source;
  for (const heart::NormalRange& range : monitor_.normals(normalsOf_, person_)) {
    if (!inMilliliters(range))
      continue;
    parts.push_back(tr("%1 %2 ml").arg(inWords(range.name), rangeText(range)));
    source = shortSource(inWords(range.source));
    from = tr("%1: %2").arg(inWords(range.source),
                            QStringLiteral("%1; %2").arg(inWords(range.meaning), inWords(range.people)));
  }
  if (parts.isEmpty())
    return {};
  const QString shaded = tr("Shaded: normal for %1, %2. %3");
  const QString ranges = parts.join(tr(", "));
  return {shaded.arg(line.name, ranges, from), shaded.arg(line.name, ranges, source),
          shaded.arg(line.name, source, QString()).trimmed(), source};
}

QString VolumePanel::detailOf(std::size_t line) const {
  const VolumeMonitor::Line& shown = monitor_.lines()[line];
  if (const auto indices = posed() ? std::nullopt : monitor_.indices(line))
    return (monitor_.isEstimate(line) ? tr("EF about %1 %  SV about %2 ml (estimate)")
                                      : tr("EF %1 %  SV %2 ml"))
        .arg(formatNumber(kPercent * indices->ejectionFraction, 0))
        .arg(formatNumber(indices->strokeVolumeMl, 0));
  if (shown.restMl <= 0)
    return {};
  return tr("%1 % of rest").arg(formatNumber(kPercent * shown.nowMl / shown.restMl, 1));
}

/// Sets the contents of the chart: one cycle, the sequence as played, or the drags. Other contents begin with
/// an empty chart.
void VolumePanel::take(const sequences::VolumeRecord* record) {
  if (std::exchange(shown_, record) == record)
    return;
  chart_->clear();
  charted_ = 0;
}

void VolumePanel::followFrame() {
  if (!followsLines())
    return;
  for (std::size_t line = 0; line < tiles_.size(); ++line) {
    tiles_[line].value->setText(formatMilliliters(monitor_.lines()[line].nowMl));
    tiles_[line].detail->setText(detailOf(line));
  }
  placeCursor();
}

void VolumePanel::refreshIfNew() {
  const bool known = cycleDrawn() && shown_ == nullptr && drawnCycles_ == monitor_.cycles() &&
                     (normalsOf_ >= monitor_.lines().size() || monitor_.beats(normalsOf_) == normalsBeat_);
  known ? followFrame() : refresh();
}

void VolumePanel::refresh() {
  if (!followsLines())
    return;
  if (normalsOf_ < monitor_.lines().size() && monitor_.beats(normalsOf_) != normalsBeat_)
    syncNormals();
  followFrame();
  if (!isVisible())
    return;
  const bool cycle = cycleDrawn();
  bool anything = dragsShown() || (!posed() && monitor_.record().rows() >= 2);
  for (std::size_t line = 0; cycle && line < tiles_.size(); ++line)
    anything = anything || !monitor_.cycle(line).fractions.empty();
  stack_->setCurrentIndex(anything ? 1 : 0);
  normals_->setVisible(anything && !posed() && !dragsShown() && !source_->fullText().isEmpty());
  cycle ? drawCycle() : drawRecord();
  chart_->update();
  if (!drawing_.isActive())
    drawing_.start();
}

void VolumePanel::draw() {
  if (!isVisible())
    return;
  chart_->update(); // Its size may have changed.
  chartWidget_->renderWindow()->Render();
  placeCursor();
}

/// Places that of a cycle. Of what went by, the cursor is the end of the curves and drawn with them.
void VolumePanel::placeCursor() {
  ChartCursor::Marks marks;
  if (cycleDrawn() && playback_.showing())
    if (const auto place = chart_->placeOf(playback_.player().fraction() * cycleLength()))
      marks.lines.push_back({place->x, place->low, place->high});
  const auto line = cycleDrawn() && !monitor_.hasSecond() ? monitor_.measuredLine() : std::nullopt;
  if (const auto ends = line ? monitor_.ends(*line, view_.state().cycleEnds) : std::nullopt)
    for (const double end : {ends->diastole, ends->systole})
      if (const auto place = chart_->placeOf(end * cycleLength()))
        marks.lines.push_back({place->x, place->low, place->low + kEndMark * (place->high - place->low)});
  cursor_->setMarks(std::move(marks));
}

/// The length on the chart's axis: seconds, or parts of the cycle in per cent.
double VolumePanel::cycleLength() const {
  return monitor_.hasSecond() ? kPercent : std::max(playback_.player().periodSeconds(), 1e-3);
}

/// The curves of two views lie over one another by their part of the cycle, whatever their rates.
void VolumePanel::drawCycle() {
  take(nullptr);
  drawnCycles_ = monitor_.cycles();
  const double length = cycleLength();
  if (monitor_.hasSecond())
    chart_->setAxes(tr("Part of the cycle").toStdString(), "%", tr("Volume").toStdString(), "ml");
  else
    chart_->setAxes(tr("Time in the cycle").toStdString(), "s", tr("Volume").toStdString(), "ml");
  chart_->setTimeRange({0, length});
  for (std::size_t line = 0; line < tiles_.size(); ++line) {
    VolumeMonitor::Curve curve = monitor_.cycle(line);
    for (double& time : curve.fractions)
      time *= length;
    chart_->setCurve(static_cast<int>(line), std::move(curve.fractions), std::move(curve.milliliters));
  }
  drawPrescribed(length);
  drawMeasured(length);
  chart_->hideCursor();
}

void VolumePanel::drawRecord() {
  const bool drags = dragsShown();
  const sequences::VolumeRecord& record = drags ? monitor_.drags() : monitor_.record();
  take(&record);
  chart_->setAxes((drags ? tr("Time while dragging") : tr("Time")).toStdString(), "s",
                  tr("Volume").toStdString(), "ml");
  const std::size_t rows = record.rows();
  chart_->setTimeSpan(drags ? spanOf(rows > 0 ? record.seconds(rows - 1) : 0)
                            : std::max(kShownVolumeSeconds, 1.5 * playback_.player().periodSeconds()));
  if (rows == 0 || rows < charted_ || record.seconds(rows - 1) < chartedUntil_) {
    chart_->clear();
    charted_ = 0;
  }
  // The record drops its oldest rows when it is full: go by time, not by row.
  std::size_t row = rows;
  while (row > 0 && (charted_ == 0 || record.seconds(row - 1) > chartedUntil_))
    --row;
  for (; row < rows; ++row) {
    Values values = Values::Constant(chart_->lineCount(), std::nan(""));
    for (std::size_t line = 0; line < tiles_.size(); ++line)
      values[static_cast<Eigen::Index>(line)] = record.milliliters(row, line);
    chart_->append(record.seconds(row), values);
    chartedUntil_ = record.seconds(row);
  }
  charted_ = rows;
  if (rows > 0)
    chart_->setCursor(chartedUntil_);
  else
    chart_->hideCursor();
}

} // namespace viscera::app
