#include "window/handles/group_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QTimer>
#include <QTreeWidget>

#include <algorithm>
#include <set>

#include "viscera/document/group_commands.h"
#include "viscera/document/system_commands.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/color_palette.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

using By = document::GroupingChoice::By;

constexpr int kGroupIdRole = Qt::UserRole;
constexpr int kGroupRowsShown = 5;
constexpr int kMostGroups = 12;
/// Fewer span no region.
constexpr std::size_t kFewestGrouped = 4;

document::GroupId groupOf(const QTreeWidgetItem* item) {
  return {item->data(0, kGroupIdRole).toLongLong()};
}

/// The first system that looks at groups, or null.
std::shared_ptr<const coordinates::CoordinateSystem> groupedSystem(const coordinates::Registry& registry) {
  for (const coordinates::Registry::Entry& entry : registry.list())
    if (entry.system->traits().usesGroups)
      return entry.system;
  return nullptr;
}

} // namespace

GroupPanel::GroupPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), list_(new QTreeWidget(this)), empty_(new QLabel(this)),
      unused_(new QLabel(this)), added_(new QLabel(this)), use_(new QPushButton(this)) {
  auto* column = makeLayout<QVBoxLayout>(this, 8);
  for (QLabel* label : {empty_, unused_, added_}) {
    label->setObjectName(QStringLiteral("muted"));
    label->setWordWrap(true);
  }
  empty_->setText(tr("No groups: all handles act everywhere. Select handles and make a group of them, or "
                     "make groups automatically below."));
  list_->setObjectName(QStringLiteral("groupList"));
  list_->setAccessibleName(tr("Groups"));
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setColumnCount(2);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->setUniformRowHeights(true);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  column->addWidget(unused_);
  column->addWidget(use_);
  column->addWidget(empty_);
  column->addWidget(list_);
  column->addWidget(makeButtons());
  column->addWidget(makeAutomatic());
  column->addWidget(added_);
  connect(use_, &QPushButton::clicked, this, &GroupPanel::useGroups);
  connect(list_, &QTreeWidget::itemChanged, this, &GroupPanel::rename);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
    if (updating_)
      return;
    const auto chosen = list_->selectedItems();
    workspace_.selection().setGroup(chosen.isEmpty() ? document::GroupId{} : groupOf(chosen.front()));
  });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig() && change.before.rig->groups != change.after.rig->groups)
      rebuild();
    else if (change.rig() || change.system() || change.organs())
      sync();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  rebuild();
}

QWidget* GroupPanel::makeButtons() {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box, 4);
  int next = 0;
  const auto button = [&](const char* name, const QString& label, const QString& tip, auto clicked) {
    auto* made = new QPushButton(label, box);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, clicked);
    grid->addWidget(made, next / 2, next % 2);
    ++next;
    return made;
  };
  const auto selected = [this] { return workspace_.selection().handles(); };
  create_ = button("groupCreate", tr("New group"), tr("Make a group of the selected handles"),
                   [this] { create(); });
  select_ = button("groupSelect", tr("Select handles"), tr("Select the handles of the chosen group"), [this] {
    if (const document::Group* group = current())
      workspace_.selection().setHandles(group->handles);
  });
  add_ = button("groupAdd", tr("Add selected"), tr("Add the selected handles to the chosen group"),
                [this, selected] {
                  if (const document::Group* group = current())
                    workspace_.perform(document::addToGroup(group->id, selected()));
                });
  takeOut_ = button("groupTakeOut", tr("Take out"), tr("Take the selected handles out of the chosen group"),
                    [this, selected] {
                      if (const document::Group* group = current())
                        workspace_.perform(document::removeFromGroup(group->id, selected()));
                    });
  color_ = button("groupColor", tr("Colour..."), tr("Choose the colour of the chosen group"), [this] {
    if (const document::Group* group = current())
      chooseColorOf(*group);
  });
  remove_ =
      button("groupRemove", tr("Remove group"), tr("Remove the chosen group; its handles stay"), [this] {
        if (const document::Group* group = current())
          workspace_.perform(document::removeGroup(group->id));
      });
  return box;
}

QWidget* GroupPanel::makeAutomatic() {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box, 4, {0, 4, 0, 0});
  by_ = new QComboBox(box);
  by_->setObjectName(QStringLiteral("groupBy"));
  by_->setAccessibleName(tr("How groups are made"));
  by_->addItem(tr("Parts along the axis"), static_cast<int>(By::axis));
  by_->addItem(tr("Clusters of handles"), static_cast<int>(By::cluster));
  by_->addItem(tr("Organs and their pieces"), static_cast<int>(By::organ));
  by_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  count_ = new QSpinBox(box);
  count_->setObjectName(QStringLiteral("groupCount"));
  count_->setAccessibleName(tr("How many groups"));
  count_->setRange(1, kMostGroups);
  count_->setValue(3);
  automatic_ = new QPushButton(tr("Group automatically"), box);
  automatic_->setObjectName(QStringLiteral("groupAutomatically"));
  automatic_->setToolTip(tr("Replace the present groups. Where handles do not surround a group's part of the "
                            "organ, the corners of a box are added."));
  grid->addWidget(by_, 0, 0);
  grid->addWidget(count_, 0, 1);
  grid->addWidget(automatic_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  connect(by_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { sync(); });
  connect(automatic_, &QPushButton::clicked, this, &GroupPanel::makeAutomatically);
  return box;
}

const document::Group* GroupPanel::current() const {
  const document::Rig& rig = workspace_.document().rig();
  const int place = rig.indexOf(workspace_.selection().group());
  return place < 0 ? nullptr : &rig.groups[static_cast<std::size_t>(place)];
}

std::string GroupPanel::freeName() const {
  const auto& groups = workspace_.document().rig().groups;
  for (std::size_t number = groups.size() + 1;; ++number) {
    const std::string name = tr("Group %1").arg(number).toStdString();
    if (std::none_of(groups.begin(), groups.end(), [&](const auto& group) { return group.name == name; }))
      return name;
  }
}

void GroupPanel::create() {
  const auto& groups = workspace_.document().rig().groups;
  if (workspace_.perform(document::addGroup(freeName(), document::groupColor(groups.size()),
                                            workspace_.selection().handles())))
    workspace_.selection().setGroup(workspace_.document().rig().groups.back().id);
}

void GroupPanel::makeAutomatically() {
  document::GroupingChoice choice;
  choice.by = static_cast<By>(by_->currentData().toInt());
  choice.count = count_->value();
  workspace_.perform(document::groupAutomatically(choice));
}

QString GroupPanel::added() const {
  const document::Rig& rig = workspace_.document().rig();
  std::set<document::HandleId> corners;
  for (const document::Handle& handle : rig.handles)
    if (handle.description == document::kAddedByGrouping)
      corners.insert(handle.id);
  const auto where = std::count_if(rig.groups.begin(), rig.groups.end(), [&](const document::Group& group) {
    return std::any_of(group.handles.begin(), group.handles.end(),
                       [&](document::HandleId id) { return corners.count(id) > 0; });
  });
  const int count = static_cast<int>(corners.size());
  if (count == 0 || where == 0)
    return {};
  if (rig.groups.size() == 1)
    return tr("Automatic grouping has added %n corner handles to the group.", nullptr, count);
  return tr("Automatic grouping has added %n corner handles to %1 of %2 groups.", nullptr, count)
      .arg(where)
      .arg(rig.groups.size());
}

void GroupPanel::useGroups() {
  const auto system = groupedSystem(workspace_.registry());
  if (!system)
    return;
  document::SystemChoice choice;
  choice.id = system->id();
  workspace_.undo().seal();
  workspace_.perform(document::setSystem(choice));
  workspace_.undo().seal();
}

void GroupPanel::chooseColorOf(const document::Group& group) {
  chooseColor(
      this, color_->mapToGlobal(QPoint(0, color_->height())), asColor(group.color),
      [this, id = group.id](const QColor& color) {
        document::GroupEdit edit;
        edit.color = asVec3(color);
        workspace_.perform(document::editGroup(id, edit));
      },
      [this] { workspace_.undo().seal(); });
}

void GroupPanel::rename(QTreeWidgetItem* item) {
  if (updating_)
    return;
  for (const document::Group& group : workspace_.document().rig().groups)
    if (group.id == groupOf(item) && item->text(0) == inWords(group.name))
      return; // Left as it was shown, which may be a translation.
  document::GroupEdit edit;
  edit.name = item->text(0).trimmed().toStdString();
  // Later: the list is made anew, and the item that is telling us would be gone.
  QTimer::singleShot(0, this, [this, id = groupOf(item), edit] {
    if (!workspace_.perform(document::editGroup(id, edit)))
      rebuild();
  });
}

void GroupPanel::rebuild() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  list_->clear();
  const auto& groups = workspace_.document().rig().groups;
  for (const document::Group& group : groups) {
    auto* item = new QTreeWidgetItem(list_);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setData(0, kGroupIdRole, static_cast<qlonglong>(group.id.value));
    item->setText(0, inWords(group.name));
    item->setIcon(0, swatch(asColor(group.color)));
    item->setText(1, QString::number(group.handles.size()));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setToolTip(0, item->text(0) + QLatin1Char('\n') + tr("F2 renames"));
    if (group.handles.size() < kFewestGrouped) {
      item->setIcon(1, icon("warning"));
      item->setToolTip(1, tr("A region needs at least four handles"));
    }
  }
  const int rows = std::clamp(static_cast<int>(groups.size()), 2, kGroupRowsShown);
  list_->setFixedHeight(rows * std::max(list_->sizeHintForRow(0), 20) + 2 * list_->frameWidth() + 2);
  list_->setVisible(!groups.empty());
  empty_->setVisible(groups.empty());
  sync();
}

void GroupPanel::sync() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::Group* group = current();
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* item = list_->topLevelItem(row);
    item->setSelected(group && groupOf(item) == group->id);
  }
  const bool handles = !workspace_.selection().handles().empty();
  create_->setEnabled(handles);
  add_->setEnabled(group && handles);
  takeOut_->setEnabled(group && handles);
  select_->setEnabled(group != nullptr);
  color_->setEnabled(group != nullptr);
  remove_->setEnabled(group != nullptr);
  automatic_->setEnabled(!workspace_.document().organs().empty() &&
                         !workspace_.document().rig().handles.empty());
  count_->setEnabled(static_cast<By>(by_->currentData().toInt()) != By::organ);

  const QString added = this->added();
  added_->setText(added);
  added_->setVisible(!added.isEmpty());

  const auto grouped = groupedSystem(workspace_.registry());
  const std::string& id = workspace_.document().system().id;
  const bool looksAtGroups =
      workspace_.registry().contains(id) && workspace_.registry().find(id)->traits().usesGroups;
  unused_->setText(grouped ? tr("These coordinates do not use groups.")
                           : tr("No coordinate system that uses groups is loaded: the plugin is missing."));
  unused_->setVisible(!looksAtGroups);
  use_->setVisible(!looksAtGroups && grouped);
  if (grouped)
    use_->setText(tr("Use %1").arg(inWords(grouped->name())));
}

} // namespace viscera::app
