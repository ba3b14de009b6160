#include "window/timeline/volume_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStackedLayout>

#include <algorithm>
#include <utility>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

namespace viscera::app {
namespace {
constexpr double kShownSeconds = 5;
constexpr double kShownDragSeconds = 12;
constexpr int kTileWidth = 148;
} // namespace

VolumePanel::VolumePanel(VolumeMonitor& monitor, Playback& playback, QWidget* parent)
    : QWidget(parent), monitor_(monitor), playback_(playback), chart_(std::make_unique<scene::VolumeChart>()),
      chartWidget_(new QVTKOpenGLNativeWidget(this)), stack_(new QStackedLayout),
      tileArea_(new QWidget(this)) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 4, 8, 4);
  row->setSpacing(8);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("panelScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(2 * kTileWidth + 24);
  tileArea_->setObjectName(QStringLiteral("page"));
  tileArea_->setAttribute(Qt::WA_StyledBackground);
  new QVBoxLayout(tileArea_);
  tileArea_->layout()->setContentsMargins(8, 0, 0, 0);
  scroll->setWidget(tileArea_);
  row->addWidget(scroll);
  row->addLayout(stack_, 1);
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
  chart_->setAxes(tr("Time").toStdString(), "s", tr("Volume").toStdString(), "ml");
  chart_->setTimeSpan(kShownSeconds);
  connect(&monitor, &VolumeMonitor::linesChanged, this, &VolumePanel::rebuild);
  connect(&monitor, &VolumeMonitor::updated, this, &VolumePanel::refresh);
  connect(&playback, &Playback::stateChanged, this, &VolumePanel::refresh);
  rebuild();
}

VolumePanel::~VolumePanel() {
  chart_->setWindow(nullptr);
}

void VolumePanel::setTheme(const Theme& theme) {
  scene::Theme colors = theme.kind == ThemeKind::dark ? scene::darkTheme() : scene::lightTheme();
  colors.panel = {theme.panel.redF(), theme.panel.greenF(), theme.panel.blueF()};
  chart_->setTheme(colors);
  refresh();
}

void VolumePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void VolumePanel::rebuild() {
  delete tileBox_;
  tiles_.clear();
  tileBox_ = new QWidget(tileArea_);
  auto* grid = new QGridLayout(tileBox_);
  grid->setContentsMargins(4, 0, 4, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(6);
  std::vector<scene::ChartLine> lines;
  const auto isCavity = [](const VolumeMonitor::Line& line) { return line.cavity; };
  const bool cavities = std::any_of(monitor_.lines().begin(), monitor_.lines().end(), isCavity);
  for (const VolumeMonitor::Line& line : monitor_.lines()) {
    tiles_.push_back(addTile(line));
    // A whole organ is so much larger than its cavities that on one axis neither would be seen to move.
    const bool right = cavities && !line.cavity;
    const QString name = right ? tr("%1 (right axis)").arg(line.name) : line.name;
    lines.push_back({name.toStdString(), line.color, false, {}, right});
  }
  if (tiles_.empty()) {
    auto* hint = new QLabel(tr("Closed organs show their volume here."), tileBox_);
    hint->setObjectName(QStringLiteral("muted"));
    hint->setWordWrap(true);
    grid->addWidget(hint, 0, 0);
  }
  grid->setRowStretch(grid->rowCount(), 1);
  static_cast<QVBoxLayout*>(tileArea_->layout())->addWidget(tileBox_);
  tileBox_->show();
  chart_->setLines(lines);
  charted_ = 0;
  refresh();
}

VolumePanel::Tile VolumePanel::addTile(const VolumeMonitor::Line& line) {
  auto* grid = static_cast<QGridLayout*>(tileBox_->layout());
  const int index = static_cast<int>(tiles_.size());
  auto* box = new QWidget(tileBox_);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* name = new QLabel(box);
  const QColor color = QColor::fromRgbF(line.color.x(), line.color.y(), line.color.z());
  name->setText(QStringLiteral("<span style='color:%1'>&#9632;</span> %2")
                    .arg(color.name(), line.name.toHtmlEscaped()));
  Tile tile{new QLabel(box), new QLabel(box)};
  QFont font = tile.value->font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setBold(true);
  tile.value->setFont(font);
  tile.detail->setObjectName(QStringLiteral("muted"));
  column->addWidget(name);
  column->addWidget(tile.value);
  column->addWidget(tile.detail);
  grid->addWidget(box, index / 2, index % 2);
  return tile;
}

QString VolumePanel::detailOf(std::size_t line) const {
  const VolumeMonitor::Line& shown = monitor_.lines()[line];
  if (const auto indices = monitor_.indices(line))
    return tr("EF %1 %  SV %2 ml")
        .arg(100 * indices->ejectionFraction, 0, 'f', 0)
        .arg(indices->strokeVolumeMl, 0, 'f', 0);
  if (shown.restMl <= 0)
    return {};
  return tr("%1 % of rest").arg(100 * shown.nowMl / shown.restMl, 0, 'f', 1);
}

const session::VolumeRecord& VolumePanel::shownRecord() {
  const bool drags = !playback_.showing();
  const session::VolumeRecord& record = drags ? monitor_.drags() : monitor_.record();
  if (std::exchange(shown_, &record) != &record) {
    chart_->clear();
    charted_ = 0;
    chart_->setAxes((drags ? tr("Time dragged") : tr("Time")).toStdString(), "s", tr("Volume").toStdString(),
                    "ml");
    chart_->setTimeSpan(drags ? kShownDragSeconds : kShownSeconds);
  }
  return record;
}

void VolumePanel::refresh() {
  for (std::size_t line = 0; line < tiles_.size(); ++line) {
    tiles_[line].value->setText(formatMilliliters(monitor_.lines()[line].nowMl));
    tiles_[line].detail->setText(detailOf(line));
  }
  if (!isVisible())
    return;
  const session::VolumeRecord& record = shownRecord();
  const std::size_t rows = record.rows();
  stack_->setCurrentIndex(rows < 2 ? 0 : 1);
  if (rows == 0 || rows < charted_ || record.seconds(rows - 1) < chartedUntil_) {
    chart_->clear();
    charted_ = 0;
  }
  // The record drops its oldest rows when it is full: go by time, not by row.
  std::size_t row = rows;
  while (row > 0 && (charted_ == 0 || record.seconds(row - 1) > chartedUntil_))
    --row;
  for (; row < rows; ++row) {
    Values values(static_cast<Eigen::Index>(tiles_.size()));
    for (Eigen::Index line = 0; line < values.size(); ++line)
      values[line] = record.milliliters(row, static_cast<std::size_t>(line));
    chart_->append(record.seconds(row), values);
    chartedUntil_ = record.seconds(row);
  }
  charted_ = rows;
  chart_->update();
  chartWidget_->renderWindow()->Render();
}

} // namespace viscera::app
