#include "window/stress/marks_box.h"

#include <QAction>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <set>

#include "viscera/document/stress_mark_commands.h"
#include "viscera/presentation/presenter.h"
#include "window/stress/probe_card.h"
#include "window/stress/profile_chart.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/list_keys.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

enum MarkColumn { kMarkNumber, kMarkPlace, kMarkValue, kMarkOrgan, kMarkColumns };
constexpr int kMarkIdRole = Qt::UserRole;
constexpr int kMarkRowsShown = 6;
constexpr int kDecimals = 1; ///< Of places, mm.

qlonglong idOf(const QTreeWidgetItem& item) {
  return item.data(kMarkNumber, kMarkIdRole).toLongLong();
}

} // namespace

MarksBox::MarksBox(Workspace& workspace, StressModel& model, const Actions& actions, QWidget* parent)
    : QWidget(parent), workspace_(workspace), model_(model), list_(new QTreeWidget(this)),
      profile_(new QPushButton(icon("chart"), tr("Profile"), this)),
      remove_(new QPushButton(icon("remove"), tr("Remove"), this)), chart_(new ProfileChart(model, this)) {
  auto* grid = makeLayout<QGridLayout>(this, 4);
  grid->addWidget(makeActionButton(actions["stress.pinProbe"], this), 0, 0, 1, 2);
  makeList();
  grid->addWidget(list_, 1, 0, 1, 2);
  profile_->setObjectName(QStringLiteral("stressProfile"));
  profile_->setToolTip(tr("Draw the values along the straight line at rest between two chosen probes, or "
                          "between the last two"));
  connect(profile_, &QPushButton::clicked, this, &MarksBox::drawProfile);
  grid->addWidget(profile_, 2, 0);
  remove_->setObjectName(QStringLiteral("stressRemoveMarks"));
  remove_->setToolTip(tr("Remove the chosen probes and profiles (Delete in the list)"));
  connect(remove_, &QPushButton::clicked, this, &MarksBox::removeChosen);
  grid->addWidget(remove_, 2, 1);
  grid->addWidget(chart_, 3, 0, 1, 2);
  QPushButton* probes = makeActionButton(actions["stress.exportProbes"], this);
  QPushButton* profiles = makeActionButton(actions["stress.exportProfiles"], this);
  grid->addWidget(probes, 4, 0, 1, 2);
  grid->addWidget(profiles, 5, 0, 1, 2);
  forAll_ = {list_, profile_, remove_, probes, profiles};
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  connect(&model, &StressModel::numbersChanged, this, &MarksBox::syncValues);
  connect(&model, &StressModel::updated, this, [this] {
    syncValues();
    chart_->refresh();
  });
  connect(&model, &StressModel::marksChanged, this, &MarksBox::rebuild);
  rebuild();
}

void MarksBox::makeList() {
  list_->setObjectName(QStringLiteral("stressMarks"));
  list_->setAccessibleName(tr("Probes and profiles"));
  list_->setColumnCount(kMarkColumns);
  list_->setHeaderLabels({tr("No."), tr("Place (mm)"), tr("Value"), tr("Organ")});
  list_->headerItem()->setToolTip(kMarkPlace, tr("Place in the pose: towards the right (R) or left (L), "
                                                 "front (A) or back (P), foot (I) or head (S)"));
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->header()->setStretchLastSection(false);
  list_->header()->setMinimumSectionSize(24);
  for (const int column : {kMarkNumber, kMarkValue, kMarkOrgan})
    list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(kMarkPlace, QHeaderView::Stretch);
  list_->headerItem()->setTextAlignment(kMarkValue, Qt::AlignRight | Qt::AlignVCenter);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  (new ListKeys(list_))->add(Qt::Key_Delete, [this] { removeChosen(); });
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &MarksBox::syncButtons);
}

void MarksBox::setTheme(const Theme& theme) {
  chart_->setTheme(theme);
}

/// Marks of organs that are gone wait for an undo and are not listed.
void MarksBox::rebuild() {
  list_->clear();
  const document::StressMarks& marks = workspace_.document().stressMarks();
  std::set<document::OrganId> organs;
  const auto add = [this](std::int64_t id) {
    auto* item = new QTreeWidgetItem(list_);
    item->setData(kMarkNumber, kMarkIdRole, static_cast<qlonglong>(id));
    item->setTextAlignment(kMarkValue, Qt::AlignRight | Qt::AlignVCenter);
  };
  for (const document::StressProbe& probe : marks.probes)
    if (workspace_.document().organ(probe.organ)) {
      add(probe.id.value);
      organs.insert(probe.organ);
    }
  for (const document::StressLine& line : marks.lines)
    if (const auto* from = marks.probe(line.from); from && workspace_.document().organ(from->organ))
      add(line.id.value);
  list_->setColumnHidden(kMarkOrgan, organs.size() < 2);
  const int rows = list_->topLevelItemCount();
  for (QWidget* widget : forAll_)
    widget->setVisible(rows > 0);
  syncValues();
  chart_->refresh();
  const int rowHeight = rows > 0 ? list_->sizeHintForRow(0) : 0;
  list_->setFixedHeight(list_->header()->sizeHint().height() + std::min(rows, kMarkRowsShown) * rowHeight +
                        2 * list_->frameWidth() + 2);
  syncButtons();
}

void MarksBox::fill(QTreeWidgetItem& item, const document::StressProbe& probe) const {
  const auto& read = model_.marks().probes;
  const auto found = std::find_if(read.begin(), read.end(),
                                  [&](const live::ReadProbe& one) { return one.probe.id == probe.id; });
  const auto organ = workspace_.document().organ(probe.organ);
  const QString name = organ ? inWords(presentation::labelOf(*organ)) : QString();
  item.setText(kMarkNumber, QString::number(probe.number));
  item.setText(kMarkOrgan, name);
  const QString rest = tr("%1: at rest %2 mm").arg(name, ProbeCard::placeInWords(probe.rest));
  for (const int column : {kMarkNumber, kMarkPlace, kMarkValue, kMarkOrgan})
    item.setToolTip(column, rest);
  if (found == read.end()) {
    item.setText(kMarkPlace, ProbeCard::placeInWords(probe.rest));
    return item.setText(kMarkValue, QStringLiteral("-"));
  }
  const live::StressReading& reading = found->reading;
  const double value = live::valueOf(reading, model_.look().measure());
  item.setText(kMarkPlace, ProbeCard::placeInWords(reading.inTissue ? reading.now : probe.rest));
  item.setText(kMarkValue, !reading.inTissue                  ? tr("no tissue")
                           : !model_.look().measure().known() ? QStringLiteral("-")
                           : !std::isfinite(value)            ? tr("folded")
                                                              : model_.format(value));
}

void MarksBox::fill(QTreeWidgetItem& item, const document::StressLine& line) const {
  const document::StressMarks& marks = workspace_.document().stressMarks();
  const document::StressProbe *from = marks.probe(line.from), *to = marks.probe(line.to);
  item.setText(kMarkNumber, text(marks.nameOf(line)));
  item.setText(kMarkPlace, tr("%1 mm long").arg(formatNumber((to->rest - from->rest).norm(), kDecimals)));
  const auto organ = workspace_.document().organ(from->organ);
  item.setText(kMarkOrgan, organ ? inWords(presentation::labelOf(*organ)) : QString());
  double largest = -1;
  for (const live::ReadProfile& read : model_.marks().profiles)
    if (read.line.id == line.id)
      for (const live::StressReading& reading : read.profile.readings)
        if (const double value = live::valueOf(reading, model_.look().measure()); std::isfinite(value))
          largest = std::max(largest, value);
  item.setText(kMarkValue, largest < 0 ? QStringLiteral("-") : model_.format(largest));
  for (const int column : {kMarkNumber, kMarkPlace, kMarkValue, kMarkOrgan})
    item.setToolTip(column, tr("Profile along the line between two probes; the value is the largest"));
}

void MarksBox::syncValues() {
  const document::StressMarks& marks = workspace_.document().stressMarks();
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem& item = *list_->topLevelItem(row);
    const auto* probe = marks.probe({idOf(item)});
    if (probe) {
      fill(item, *probe);
      continue;
    }
    for (const document::StressLine& line : marks.lines)
      if (line.id.value == idOf(item))
        fill(item, line);
  }
}

std::vector<document::StressProbeId> MarksBox::chosenProbes() const {
  std::vector<document::StressProbeId> chosen;
  for (const QTreeWidgetItem* item : list_->selectedItems())
    if (const document::StressProbeId id{idOf(*item)}; workspace_.document().stressMarks().probe(id))
      chosen.push_back(id);
  return chosen;
}

std::vector<document::StressLineId> MarksBox::chosenLines() const {
  std::vector<document::StressLineId> chosen;
  for (const QTreeWidgetItem* item : list_->selectedItems())
    for (const document::StressLine& line : workspace_.document().stressMarks().lines)
      if (line.id.value == idOf(*item))
        chosen.push_back(line.id);
  return chosen;
}

void MarksBox::syncButtons() {
  remove_->setEnabled(!list_->selectedItems().isEmpty());
  const std::size_t chosen = chosenProbes().size();
  profile_->setEnabled(chosen == 2 || (chosen < 2 && model_.marks().probes.size() >= 2));
}

/// Lines that end at a removed probe go with it, in the same step.
void MarksBox::removeChosen() {
  const auto probes = chosenProbes();
  const auto lines = chosenLines();
  if (!probes.empty())
    workspace_.perform(document::removeStressProbes(probes));
  std::vector<document::StressLineId> left;
  for (const document::StressLineId id : lines)
    for (const document::StressLine& line : workspace_.document().stressMarks().lines)
      if (line.id == id)
        left.push_back(id);
  if (!left.empty())
    workspace_.perform(document::removeStressLines(left));
}

void MarksBox::drawProfile() {
  auto ends = chosenProbes();
  const auto& read = model_.marks().probes;
  if (ends.size() != 2 && read.size() >= 2)
    ends = {read[read.size() - 2].probe.id, read.back().probe.id};
  if (ends.size() == 2)
    workspace_.perform(document::addStressLine(ends[0], ends[1]));
}

} // namespace viscera::app
