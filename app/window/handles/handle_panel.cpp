#include "window/handles/handle_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <map>

#include "viscera/document/rig_commands.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/color_palette.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/value_slider.h"

namespace viscera::app {
namespace {

constexpr int kHandleIdRole = Qt::UserRole;
const QColor kUngrouped(242, 158, 51);

document::HandleId handleOf(const QTreeWidgetItem* item) {
  return {item->data(0, kHandleIdRole).toLongLong()};
}

} // namespace

HandlePanel::HandlePanel(Workspace& workspace, HandlePlacer& placer, QWidget* parent)
    : QWidget(parent), workspace_(workspace), placer_(placer), tools_(new QWidget(this)),
      list_(new QTreeWidget(this)), empty_(makeRemark({}, this)) {
  setObjectName(QStringLiteral("panel"));
  auto* column = makeLayout<QVBoxLayout>(this, 4, {0, 8, 0, 0});
  column->addWidget(makePlacement());
  auto* row = makeLayout<QHBoxLayout>(tools_, 4, {8, 0, 8, 0});
  row->addStretch(1);
  column->addWidget(tools_);
  empty_->setText(
      tr("No handles yet.\nMove the slider above to place some, or click the organ in Handles mode (2)."));
  empty_->setContentsMargins(12, 8, 12, 8);
  empty_->setAlignment(Qt::AlignTop);
  column->addWidget(empty_, 1);
  list_->setObjectName(QStringLiteral("handleList"));
  list_->setHeaderHidden(true);
  list_->setIndentation(14);
  list_->setUniformRowHeights(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  list_->setMinimumHeight(80);
  column->addWidget(list_, 1);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &HandlePanel::selectFromList);
  connect(list_, &QTreeWidget::itemChanged, this, &HandlePanel::rename);
  connect(&placer, &HandlePlacer::placementChanged, this, &HandlePanel::syncPlacement);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig() &&
        !(change.interactive && change.before.rig->handles.size() == change.after.rig->handles.size()))
      rebuild();
    if (change.organs())
      syncPlacement();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncSelection(); }));
  syncPlacement();
  rebuild();
}

QWidget* HandlePanel::makePlacement() {
  auto* box = new QWidget(this);
  auto* column = makeLayout<QVBoxLayout>(box, 4, {12, 0, 12, 0});
  count_ = new ValueSlider(tr("Place automatically"),
                           {double(placer_.fewest()), double(placer_.most()), 1, 0, QString()}, box);
  count_->setObjectName(QStringLiteral("handleCount"));
  count_->setToolTip(tr(
      "Place this many handles evenly, a little outside the organ's surface; they replace the present ones"));
  enclosing_ = new QCheckBox(tr("Enclosing box"), box);
  enclosing_->setToolTip(
      tr("Eight of the handles are the corners of a box around the organ, so that all of it lies inside"));
  column->addWidget(count_);
  column->addWidget(enclosing_);
  connect(count_, &ValueSlider::valueChanged, this,
          [this](double count) { placer_.setCount(static_cast<int>(count)); });
  connect(count_, &ValueSlider::valueChosen, this, [this] { placer_.finish(); });
  connect(enclosing_, &QCheckBox::clicked, this, [this](bool on) { placer_.setEnclosing(on); });
  return box;
}

void HandlePanel::addTool(QAction* action) {
  auto* button = new QToolButton(tools_);
  button->setDefaultAction(action);
  button->setIconSize(QSize(18, 18));
  auto* row = static_cast<QHBoxLayout*>(tools_->layout());
  row->insertWidget(row->count() - 1, button);
}

void HandlePanel::syncPlacement() {
  count_->setRange(placer_.fewest(), placer_.most());
  count_->setValue(placer_.placement().count);
  enclosing_->setChecked(placer_.placement().enclosing);
  const bool possible = !workspace_.document().organs().empty();
  count_->setEnabled(possible);
  enclosing_->setEnabled(possible);
}

void HandlePanel::rebuild() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::Rig& rig = workspace_.document().rig();
  std::map<const document::Group*, std::vector<const document::Handle*>> members;
  for (const document::Group& group : rig.groups)
    for (const document::HandleId id : group.handles)
      members[&group].push_back(&rig.handles[static_cast<std::size_t>(rig.indexOf(id))]);
  for (const document::Handle& handle : rig.handles)
    if (!rig.groupOf(handle.id))
      members[nullptr].push_back(&handle);
  list_->clear();
  for (const document::Group& group : rig.groups)
    addGroup(inWords(group.name), asColor(group.color), members[&group]);
  if (const auto& alone = members[nullptr]; !alone.empty())
    addGroup(tr("Handles"), kUngrouped, alone);
  if (list_->topLevelItemCount() == 1)
    list_->expandAll();
  empty_->setVisible(rig.handles.empty());
  list_->setVisible(!rig.handles.empty());
  syncSelection();
}

void HandlePanel::addGroup(const QString& name, const QColor& color,
                           const std::vector<const document::Handle*>& handles) {
  auto* parent = new QTreeWidgetItem(list_);
  parent->setText(0, tr("%1 (%2)").arg(name).arg(handles.size()));
  parent->setIcon(0, swatch(color));
  parent->setToolTip(0, parent->text(0));
  for (const document::Handle* handle : handles) {
    auto* item = new QTreeWidgetItem(parent);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setData(0, kHandleIdRole, static_cast<qlonglong>(handle->id.value));
    item->setText(0, inWords(handle->label));
    if (handle->locked)
      item->setIcon(0, icon("lock"));
    item->setToolTip(
        0, item->text(0) + QLatin1Char('\n') +
               (handle->description.empty() ? tr("F2 renames, Delete removes") : text(handle->description)));
  }
}

void HandlePanel::syncSelection() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::HandleId current = workspace_.selection().currentHandle();
  for (QTreeWidgetItemIterator item(list_); *item; ++item) {
    const document::HandleId id = handleOf(*item);
    if (!id)
      continue;
    (*item)->setSelected(workspace_.selection().contains(id));
    if (id == current) {
      (*item)->parent()->setExpanded(true);
      list_->scrollToItem(*item);
    }
  }
}

void HandlePanel::selectFromList() {
  if (updating_)
    return;
  std::vector<document::HandleId> ids;
  for (const QTreeWidgetItem* item : list_->selectedItems()) {
    if (const document::HandleId id = handleOf(item))
      ids.push_back(id);
    // A group stands for all its handles.
    for (int child = 0; child < item->childCount(); ++child)
      ids.push_back(handleOf(item->child(child)));
  }
  // The row that was clicked is the current one.
  if (const auto* current = list_->currentItem(); current && current->isSelected())
    if (const document::HandleId id = handleOf(current); std::erase(ids, id) > 0)
      ids.push_back(id);
  workspace_.selection().setHandles(ids);
}

void HandlePanel::rename(QTreeWidgetItem* item) {
  if (updating_ || !handleOf(item))
    return;
  document::HandleEdit edit;
  edit.label = item->text(0).trimmed().toStdString();
  // Later: the list is made anew, and the item that is telling us would be gone.
  QTimer::singleShot(0, this, [this, id = handleOf(item), edit] {
    if (!workspace_.perform(document::editHandles({id}, edit)))
      rebuild();
  });
}

} // namespace viscera::app
