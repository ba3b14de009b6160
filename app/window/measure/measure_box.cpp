#include "window/measure/measure_box.h"

#include <QAction>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>

#include <algorithm>

#include "viscera/document/measurement_commands.h"
#include "viscera/presentation/presenter.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/view/picture.h"
#include "window/widgets/list_keys.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

enum MeasurementColumn { kMeasurementName, kMeasurementNow, kMeasurementRest, kMeasurementColumns };
constexpr int kMeasurementIdRole = Qt::UserRole;
constexpr int kMeasurementRowsShown = 6;

document::MeasurementId idOf(const QTreeWidgetItem* item) {
  return {item->data(kMeasurementName, kMeasurementIdRole).toLongLong()};
}

} // namespace

MeasureBox::MeasureBox(Workspace& workspace, MeasureTool& tool, const Actions& actions, QWidget* parent)
    : QWidget(parent), workspace_(workspace), tool_(tool), hint_(makeRemark({}, this)),
      list_(new QTreeWidget(this)), remove_(new QPushButton(icon("remove"), tr("Remove"), this)) {
  setObjectName(QStringLiteral("measureBox"));
  auto* grid = makeLayout<QGridLayout>(this, 4);
  grid->addWidget(makeActionButton(actions["measure.distance"], this), 0, 0);
  grid->addWidget(makeActionButton(actions["measure.angle"], this), 0, 1);
  grid->addWidget(makeActionButton(actions["measure.rectangle"], this), 1, 0);
  grid->addWidget(makeActionButton(actions["measure.sphere"], this), 1, 1);
  grid->addWidget(makeActionButton(actions["measure.gap"], this), 2, 0, 1, 2);
  grid->addWidget(hint_, 3, 0, 1, 2);
  makeList();
  grid->addWidget(list_, 4, 0, 1, 2);
  remove_->setObjectName(QStringLiteral("measureRemove"));
  remove_->setToolTip(tr("Remove the chosen measurement (Delete in the list)"));
  connect(remove_, &QPushButton::clicked, this, &MeasureBox::removeChosen);
  grid->addWidget(remove_, 5, 0);
  forAll_ = {makeActionButton(actions["measure.removeAll"], this),
             makeActionButton(actions["export.measurements"], this)};
  forAll_[0]->setText(tr("Remove all"));
  forAll_[1]->setText(tr("Export CSV..."));
  grid->addWidget(forAll_[0], 5, 1);
  grid->addWidget(forAll_[1], 6, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  values_.setSingleShot(true);
  connect(&values_, &QTimer::timeout, this, &MeasureBox::syncValues);
  connect(&tool, &MeasureTool::changed, this, &MeasureBox::syncChosen);
  connect(&tool, &MeasureTool::stateChanged, this, &MeasureBox::syncChosen);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.measurements())
      rebuild();
    else if (change.scan())
      syncValues();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if ((event.moved || event.replaced) && !values_.isActive() && list_->topLevelItemCount() > 0)
      values_.start();
  }));
  subscriptions_.push_back(workspace.warp().onChange([this] {
    if (!values_.isActive() && list_->topLevelItemCount() > 0)
      values_.start();
  }));
  rebuild();
}

void MeasureBox::makeList() {
  list_->setObjectName(QStringLiteral("measureList"));
  list_->setAccessibleName(tr("Measurements"));
  list_->setColumnCount(kMeasurementColumns);
  list_->setHeaderLabels({tr("Name"), tr("Now"), tr("Rest shape")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(kMeasurementName, QHeaderView::Stretch);
  for (const int column : {kMeasurementNow, kMeasurementRest}) {
    list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    list_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  (new ListKeys(list_))->add(Qt::Key_Delete, [this] { removeChosen(); })->add(Qt::Key_F2, [this] {
    list_->editItem(list_->selectedItems().front(), kMeasurementName);
  });
  connect(list_, &QTreeWidget::itemChanged, this, &MeasureBox::rename);
  connect(list_, &QTreeWidget::itemDoubleClicked, this,
          [this](QTreeWidgetItem* item) { list_->editItem(item, kMeasurementName); });
  connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (updating_)
      return;
    const auto chosen = list_->selectedItems();
    tool_.choose(chosen.isEmpty() ? document::MeasurementId{} : idOf(chosen.front()));
  });
}

void MeasureBox::rebuild() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::MeasurementList& measurements = workspace_.document().measurements();
  const int rows = static_cast<int>(measurements.size());
  while (list_->topLevelItemCount() > rows)
    delete list_->takeTopLevelItem(rows);
  while (list_->topLevelItemCount() < rows)
    list_->addTopLevelItem(new QTreeWidgetItem);
  for (int row = 0; row < rows; ++row) {
    const document::Measurement& measurement = measurements[static_cast<std::size_t>(row)];
    QTreeWidgetItem* item = list_->topLevelItem(row);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setText(kMeasurementName, text(measurement.name));
    item->setToolTip(kMeasurementName, text(measurement.name));
    item->setData(kMeasurementName, kMeasurementIdRole, static_cast<qlonglong>(measurement.id.value));
    for (const int column : {kMeasurementNow, kMeasurementRest})
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  syncValues();
  const int shown = std::min(rows, kMeasurementRowsShown);
  const int rowHeight = rows > 0 ? list_->sizeHintForRow(0) : 0;
  list_->setFixedHeight(list_->header()->sizeHint().height() + shown * rowHeight + 2 * list_->frameWidth() +
                        2);
  list_->setVisible(rows > 0);
  remove_->setVisible(rows > 0);
  for (QPushButton* button : forAll_)
    button->setVisible(rows > 0);
  syncChosen();
}

void MeasureBox::syncValues() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::MeasurementList& measurements = workspace_.document().measurements();
  const char mark = decimalMark();
  for (std::size_t row = 0; row < measurements.size(); ++row) {
    const document::MeasuredValues values = document::measure(
        measurements[row], workspace_.state(),
        [this](document::OrganId organ) -> const Points& { return workspace_.live().points(organ); },
        &memory_, live::tissueMotionOf(workspace_.warp()));
    const document::MeasurementKind kind = measurements[row].kind;
    const std::string unit = document::unitOf(measurements[row], workspace_.state());
    QTreeWidgetItem* item = list_->topLevelItem(static_cast<int>(row));
    item->setText(kMeasurementNow, text(presentation::formatMeasured(kind, values.now, unit, mark)));
    // The scan's values are the same in every pose: their deviation says more than the mean once again.
    const bool region = document::isRegion(kind);
    const bool known = region && values.region && values.region->count > 0;
    item->setText(kMeasurementRest,
                  !region ? text(presentation::formatMeasured(kind, values.rest, {}, mark))
                  : known ? QStringLiteral("\u00b1 %1").arg(formatNumber(values.region->deviation, 1))
                          : QStringLiteral("-"));
    const QString spread =
        text(presentation::describeSpread(measurements[row], values, unit, translated, mark));
    for (const int column : {kMeasurementNow, kMeasurementRest})
      item->setToolTip(column, spread);
  }
}

void MeasureBox::syncChosen() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  bool any = false;
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* item = list_->topLevelItem(row);
    const bool chosen = idOf(item) == tool_.chosen();
    if (item->isSelected() != chosen)
      item->setSelected(chosen);
    any = any || chosen;
  }
  remove_->setEnabled(any);
  hint_->setText(hint());
}

QString MeasureBox::hint() const {
  using Kind = document::MeasurementKind;
  const auto kind = tool_.kind();
  if (!kind)
    return tr(
        "Points stay on the organ while it moves, and can be dragged along it; those on a slice go with the "
        "warped scan.");
  if (*kind == Kind::distance)
    return tr("Click two points on an organ or on a slice. Esc ends.");
  if (*kind == Kind::angle)
    return tr("Click three points on an organ or on a slice, the corner second. Esc ends.");
  return *kind == Kind::rectangle ? tr("Drag on a slice from corner to corner. Esc ends.")
                                  : tr("Drag on a slice from the middle to the border. Esc ends.");
}

void MeasureBox::removeChosen() {
  if (tool_.chosen())
    workspace_.perform(document::removeMeasurements({tool_.chosen()}));
}

void MeasureBox::rename(QTreeWidgetItem* item, int column) {
  if (updating_ || column != kMeasurementName)
    return;
  const document::MeasurementId id = idOf(item);
  const std::string name = item->text(kMeasurementName).trimmed().toStdString();
  if (!workspace_.perform(document::renameMeasurement(id, name)) ||
      item->text(kMeasurementName) != text(name))
    rebuild();
}

} // namespace viscera::app
