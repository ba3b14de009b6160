#include "window/key_sequence/key_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "viscera/document/key_sequence.h"
#include "viscera/document/key_sequence_commands.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/new_file.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

enum KeyColumn { kKeyTime, kKeyEasing, kKeyColumns };
constexpr double kLongest = 600; ///< s
constexpr int kShownKeys = 5;
constexpr const char* kSequenceEnding = ".sequence.json";

using sequences::Easing;
constexpr Easing kEasings[] = {Easing::smooth, Easing::linear, Easing::in, Easing::out, Easing::hold};

void fillEasings(QComboBox* box) {
  for (const Easing easing : kEasings)
    box->addItem(inWords(std::string(sequences::nameOf(easing))), static_cast<int>(easing));
}

QDoubleSpinBox* secondsBox(QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setDecimals(2);
  box->setSingleStep(0.1);
  box->setRange(0, kLongest);
  box->setSuffix(KeyBox::tr(" s"));
  box->setKeyboardTracking(false);
  return box;
}

} // namespace

KeyBox::KeyBox(Workspace& workspace, Playback& playback, KeySequencePlayback& motion, Settings& settings,
               QWidget* parent)
    : QWidget(parent), workspace_(workspace), playback_(playback), motion_(motion), settings_(settings) {
  setObjectName(QStringLiteral("keyBox"));
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  column->addWidget(
      makeRemark(tr("Pose the organ in Deform mode and press Ctrl+K: each key stores that pose."), this));
  makeTop();
  makeTable();
  makeButtons();
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.keySequence() || change.rig() || change.organs())
      sync();
  });
  sync();
}

void KeyBox::makeTop() {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  seconds_ = secondsBox(this);
  seconds_->setObjectName(QStringLiteral("keySeconds"));
  seconds_->setAccessibleName(tr("Time of the next key"));
  easing_ = new QComboBox(this);
  easing_->setObjectName(QStringLiteral("keyEasing"));
  easing_->setAccessibleName(tr("Easing to the key after it"));
  fillEasings(easing_);
  auto* add = new QPushButton(icon("add"), tr("Add key"), this);
  add->setObjectName(QStringLiteral("addKey"));
  add->setToolTip(tr("Store the present pose as a key (Ctrl+K)"));
  row->addWidget(seconds_, 1);
  row->addWidget(easing_, 1);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addLayout(row);
  column->addWidget(add); // Beside them it would widen the panel in most languages.
  connect(add, &QPushButton::clicked, this, &KeyBox::addKey);
}

void KeyBox::makeTable() {
  table_ = new QTableWidget(0, kKeyColumns, this);
  table_->setObjectName(QStringLiteral("keyTable"));
  table_->setHorizontalHeaderLabels({tr("time (s)"), tr("easing")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->hide();
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout()->addWidget(table_);
  connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (!filling_ && item->column() == kKeyTime)
      onTimeEdited(item->row());
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &KeyBox::syncButtons);
}

void KeyBox::makeButtons() {
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  const auto button = [&](const char* name, const char* iconName, const QString& label, const QString& tip,
                          int row, int column, auto action) {
    auto* made = new QPushButton(icon(iconName), label, this);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    grid->addWidget(made, row, column);
    connect(made, &QPushButton::clicked, this, action);
    return made;
  };
  take_ = button("takeKey", "deform", tr("Take pose"), tr("Set the present pose to that of this key"), 0, 0,
                 [this] { motion_.takePose(selectedKey()); });
  replace_ = button("replaceKey", "record", tr("Replace"), tr("Store the present pose in this key"), 0, 1,
                    [this] { workspace_.perform(document::replaceKey(selectedKey())); });
  remove_ = button("removeKey", "remove", tr("Remove"), tr("Remove this key"), 1, 0,
                   [this] { workspace_.perform(document::removeKeys({selectedKey()})); });
  play_ = button("playKeys", "play", tr("Play it"), tr("Play the key sequence"), 1, 1, [this] {
    playback_.choose(motion_.sequence());
    playback_.toStart();
    playback_.play();
  });
  save_ = button("saveKeys", "save", tr("Save..."), tr("Save the sequence as a file"), 2, 0, [this] {
    const QString file = fileName(true);
    if (!file.isEmpty())
      motion_.save(file);
  });
  button("openKeys", "open", tr("Open..."), tr("Open a sequence file"), 2, 1, [this] {
    const QString file = fileName(false);
    if (!file.isEmpty())
      motion_.open(file);
  });
  period_ = secondsBox(this);
  period_->setObjectName(QStringLiteral("keyPeriod"));
  period_->setPrefix(tr("Duration "));
  period_->setToolTip(tr("Duration of one cycle"));
  grid->addWidget(period_, 3, 0, 1, 2);
  connect(period_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double seconds) {
    document::KeySequenceEdit edit;
    edit.periodSeconds = seconds;
    if (!workspace_.perform(document::editKeySequence(edit)))
      sync();
  });
  static_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

void KeyBox::addKey() {
  motion_.addKey(seconds_->value(), static_cast<Easing>(easing_->currentData().toInt()));
}

document::KeyId KeyBox::selectedKey() const {
  const auto& keys = workspace_.document().keySequence().keys;
  const int row = table_->currentRow();
  return row >= 0 && row < static_cast<int>(keys.size()) ? keys[static_cast<std::size_t>(row)].id
                                                         : document::KeyId{};
}

void KeyBox::onTimeEdited(int row) {
  const std::optional<double> seconds = numberIn(table_->item(row, kKeyTime)->text());
  const auto& keys = workspace_.document().keySequence().keys;
  if (!seconds || row >= static_cast<int>(keys.size()) ||
      !workspace_.perform(document::moveKey(keys[static_cast<std::size_t>(row)].id, *seconds)))
    sync();
}

void KeyBox::fillRow(int row) {
  const document::SequenceKey& key = workspace_.document().keySequence().keys[static_cast<std::size_t>(row)];
  auto* time = new QTableWidgetItem(formatNumber(key.seconds, 2));
  time->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table_->setItem(row, kKeyTime, time);
  auto* easing = new QComboBox(table_);
  fillEasings(easing);
  easing->setCurrentIndex(easing->findData(static_cast<int>(key.easing)));
  table_->setCellWidget(row, kKeyEasing, easing);
  // Queued: the table is filled anew, and this box goes.
  connect(
      easing, QOverload<int>::of(&QComboBox::activated), this,
      [this, id = key.id, easing](int index) {
        workspace_.perform(document::setEasing({id}, static_cast<Easing>(easing->itemData(index).toInt())));
      },
      Qt::QueuedConnection);
}

void KeyBox::sync() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const document::KeySequence& keySequence = workspace_.document().keySequence();
  const int selected = table_->currentRow();
  table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(keySequence.keys.size()));
  for (int row = 0; row < table_->rowCount(); ++row)
    fillRow(row);
  if (selected >= 0 && selected < table_->rowCount())
    table_->selectRow(selected);
  const int rows = std::min(std::max(1, table_->rowCount()), kShownKeys);
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         rows * table_->verticalHeader()->defaultSectionSize() + 4);
  table_->setVisible(table_->rowCount() > 0);
  const QSignalBlocker quietPeriod(period_);
  period_->setValue(keySequence.periodSeconds);
  seconds_->setValue(motion_.nextSeconds());
  syncButtons();
}

void KeyBox::syncButtons() {
  const bool any = table_->rowCount() > 0;
  const bool one = any && static_cast<bool>(selectedKey());
  for (QPushButton* button : {take_, replace_, remove_})
    button->setEnabled(one);
  for (QWidget* widget : std::initializer_list<QWidget*>{play_, save_, period_})
    widget->setEnabled(any);
}

QString KeyBox::fileName(bool saving) const {
  const QString folder = settings_.value(kSequencesFolderKey).toString();
  auto* window = const_cast<KeyBox*>(this)->window();
  const QString filter = tr("Sequences (*%1)").arg(QLatin1String(kSequenceEnding));
  QString file = saving ? QFileDialog::getSaveFileName(
                              window, tr("Save the sequence"),
                              folder + QStringLiteral("/recorded") + QLatin1String(kSequenceEnding), filter)
                        : QFileDialog::getOpenFileName(window, tr("Open a sequence"), folder, filter);
  if (file.isEmpty())
    return file;
  settings_.setValue(kSequencesFolderKey, QFileInfo(file).absolutePath());
  return saving ? asNewFile(window, file, {QLatin1String(kSequenceEnding)}) : file;
}

} // namespace viscera::app
