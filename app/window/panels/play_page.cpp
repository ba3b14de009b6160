#include "window/panels/play_page.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>

namespace viscera::app {
namespace {
enum Column { kName, kLargest, kSmallest, kStroke, kFraction, kColumns };
constexpr double kSpeeds[] = {1, 0.5, 0.25, 0.1};
} // namespace

PlayPage::PlayPage(Playback& playback, VolumeMonitor& volumes, const Actions& actions, QWidget* parent)
    : Page(parent), playback_(playback), volumes_(volumes) {
  addSection(tr("Sequence"));
  sequence_ = addFact(tr("Motion"));
  rate_ = addFact(tr("Rate"));
  period_ = addFact(tr("One cycle"));
  phase_ = addFact(tr("Phase"));
  speed_ = new QComboBox(this);
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Slow motion: how fast time passes"));
  for (const double speed : kSpeeds)
    speed_->addItem(speed == 1 ? tr("Real time") : tr("Slow motion, 1/%1").arg(1 / speed, 0, 'f', 0), speed);
  add(speed_);
  addButton(actions["play.toggle"]);
  addCheck(actions["play.loop"]);
  addSection(tr("Volumes over the beat"));
  table_ = new QTableWidget(0, kColumns, this);
  table_->setHorizontalHeaderLabels({QString(), tr("max"), tr("min"), tr("SV"), tr("EF")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->hide();
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  add(table_);
  output_ = addFact(tr("Cardiac output"));
  addRemark(tr("Volumes in ml. SV is the stroke volume, EF the ejection fraction."));
  finish();
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { playback_.setSpeed(speed_->itemData(index).toDouble()); });
  connect(&playback, &Playback::stateChanged, this, &PlayPage::syncState);
  connect(&volumes, &VolumeMonitor::updated, this, &PlayPage::syncTable);
  connect(&volumes, &VolumeMonitor::linesChanged, this, &PlayPage::syncTable);
  syncState();
  syncTable();
}

void PlayPage::syncState() {
  const session::Player& player = playback_.player();
  const bool any = playback_.sequence() != nullptr;
  const QString none = QStringLiteral("-");
  sequence_->setText(any ? text(player.sequence()->name()) : tr("none"));
  rate_->setText(any ? tr("%1 / min").arg(player.ratePerMinute(), 0, 'f', 0) : none);
  period_->setText(any ? tr("%1 s").arg(player.periodSeconds(), 0, 'f', 2) : none);
  phase_->setText(any ? text(player.phase()) : none);
  speed_->setEnabled(any);
  const QSignalBlocker quiet(speed_);
  speed_->setCurrentIndex(speed_->findData(player.speed()));
}

void PlayPage::syncTable() {
  if (!isVisible() && table_->rowCount() == static_cast<int>(volumes_.lines().size()))
    return;
  const session::Player& player = playback_.player();
  phase_->setText(playback_.sequence() ? text(player.phase()) : QStringLiteral("-"));
  const auto& lines = volumes_.lines();
  table_->setRowCount(static_cast<int>(lines.size()));
  QString output = QStringLiteral("-");
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const auto range = volumes_.range(line);
    const auto indices = volumes_.indices(line);
    const auto number = [](bool known, double value, int decimals) {
      return known ? QString::number(value, 'f', decimals) : QStringLiteral("-");
    };
    const QStringList cells = {lines[line].name, number(range.has_value(), range ? range->high : 0, 1),
                               number(range.has_value(), range ? range->low : 0, 1),
                               number(indices.has_value(), indices ? indices->strokeVolumeMl : 0, 1),
                               indices ? tr("%1 %").arg(100 * indices->ejectionFraction, 0, 'f', 0)
                                       : QStringLiteral("-")};
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment((column == kName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      table_->setItem(static_cast<int>(line), column, item);
    }
    // The left ventricle drives the body: its output is the heart's.
    if (indices && (output.size() < 2 || lines[line].name == QLatin1String("LV")))
      output = tr("%1 l/min").arg(indices->cardiacOutputLPerMinute, 0, 'f', 1);
  }
  output_->setText(output);
  int height = table_->horizontalHeader()->height() + 2;
  for (int row = 0; row < table_->rowCount(); ++row)
    height += table_->rowHeight(row);
  table_->setFixedHeight(height);
}

} // namespace viscera::app
