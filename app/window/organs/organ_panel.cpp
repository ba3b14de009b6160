#include "window/organs/organ_panel.h"

#include <QAbstractItemDelegate>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "viscera/anatomy/organ_facts.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/presentation/presenter.h"
#include "window/organs/volume_column.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/color_palette.h"
#include "window/widgets/list_keys.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/value_slider.h"
#include "window/work/organ_looks.h"

namespace viscera::app {
namespace {

enum OrganColumn { kOrganEye, kOrganName, kOrganVolume, kOrganLock, kOrganColumns };
constexpr int kSwatchWidth = 24;
/// A change above this is shown in the accent's colour, relative.
constexpr double kNoticed = 5e-4;
constexpr int kOrganIconSize = 16;
/// More organs than that stand under the systems of the body, and can be searched.
constexpr std::size_t kFew = 12;

QTreeWidget* makeList(QWidget* parent) {
  auto* list = new QTreeWidget(parent);
  list->setObjectName(QStringLiteral("organList"));
  list->setColumnCount(kOrganColumns);
  list->setHeaderHidden(true);
  list->setTreePosition(kOrganName);
  list->setIndentation(14);
  list->setRootIsDecorated(false);
  list->setExpandsOnDoubleClick(false);
  list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list->setUniformRowHeights(true);
  list->setTextElideMode(Qt::ElideMiddle); // Left and right, upper and lower stand at the ends of names.
  list->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->header()->setStretchLastSection(false);
  list->header()->setMinimumSectionSize(24);
  list->header()->setSectionResizeMode(kOrganEye, QHeaderView::Fixed);
  list->header()->setSectionResizeMode(kOrganName, QHeaderView::Stretch);
  list->header()->setSectionResizeMode(kOrganVolume, QHeaderView::ResizeToContents);
  list->header()->setSectionResizeMode(kOrganLock, QHeaderView::Fixed);
  list->setColumnWidth(kOrganEye, 32);
  list->setColumnWidth(kOrganLock, 30);
  list->setItemDelegateForColumn(kOrganVolume, new VolumeColumn(list));
  list->setMinimumHeight(56);
  return list;
}

/// Ends the edit of a name, if one is under way, with what was typed: Qt begins no other before. May change
/// the rows.
void endEdit(const QTreeWidget& list) {
  auto* editor = list.viewport()->findChild<QLineEdit*>();
  if (!editor)
    return;
  QAbstractItemDelegate* delegate = list.itemDelegate();
  Q_EMIT delegate->commitData(editor);
  Q_EMIT delegate->closeEditor(editor);
}

} // namespace

OrganPanel::OrganPanel(Workspace& workspace, PoseEditor& poses, VolumeMonitor& volumes, QWidget* parent)
    : QWidget(parent), workspace_(workspace), poses_(poses), list_(makeList(this)),
      empty_(makeRemark({}, this)), opacity_(new ValueSlider(tr("Opacity"), {0, 100, 1, 0, tr(" %")}, this)),
      search_(new QLineEdit(this)), menu_(new OrganMenu(
                                        workspace, poses, [this] { return chosen(); }, this)) {
  setObjectName(QStringLiteral("panel"));
  opacity_->setObjectName(QStringLiteral("opacity"));
  (new ListKeys(list_))->add(Qt::Key_Delete, [this] { remove(chosen()); });
  auto* column = makeLayout<QVBoxLayout>(this, 4, {0, 4, 0, 8});
  setWaiting(false);
  empty_->setContentsMargins(12, 8, 12, 8);
  column->addWidget(empty_);
  search_->setObjectName(QStringLiteral("organSearch"));
  search_->setPlaceholderText(tr("Find an organ (Ctrl+F)"));
  search_->setClearButtonEnabled(true);
  auto* searchInset = makeLayout<QVBoxLayout>(nullptr, -1, {8, 0, 8, 0});
  searchInset->addWidget(search_);
  column->addLayout(searchInset);
  column->addWidget(list_, 1);
  auto* inset = makeLayout<QVBoxLayout>(nullptr, -1, {12, 0, 12, 0});
  inset->addWidget(opacity_);
  column->addLayout(inset);
  list_->viewport()->installEventFilter(this);
  connect(list_, &QTreeWidget::itemClicked, this, &OrganPanel::onClicked);
  connect(list_, &QTreeWidget::itemChanged, this, &OrganPanel::onChanged);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int clicked) {
    if (!organOf(item))
      item->setExpanded(!item->isExpanded());
    else if (clicked == kOrganName)
      list_->editItem(item, kOrganName);
  });
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!updating_ && item && organOf(item))
      workspace_.selection().setOrgan(organOf(item));
  });
  connect(search_, &QLineEdit::textChanged, this, &OrganPanel::filter);
  connect(search_, &QLineEdit::returnPressed, this, &OrganPanel::chooseFirstFound);
  search_->installEventFilter(this);
  connect(opacity_, &ValueSlider::valueChanged, this, [this](double percent) {
    changeLooks(workspace_, tr("Change opacity"), chosen(),
                [percent](document::OrganLook& look) { look.opacity = percent / 100; });
  });
  connect(opacity_, &ValueSlider::valueChosen, this, [this] { workspace_.undo().seal(); });
  connect(&volumes, &VolumeMonitor::shown, this, &OrganPanel::updateVolumes);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      rebuild();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncSelection(); }));
  rebuild();
}

void OrganPanel::addTo(Actions& actions) {
  actions.add("organ.showOnly",
              {tr("Show &only this"),
               "eye",
               {QKeySequence(QStringLiteral("Ctrl+I"))},
               tr("Show the chosen organs with their cavities and hide all others")},
              [this] { showOnly(workspace_, chosen()); });
  actions.add(
      "organ.hide",
      {tr("&Hide this"), "eye_off", {QKeySequence(QStringLiteral("Ctrl+H"))}, tr("Hide the chosen organs")},
      [this] {
        const auto organs = chosen();
        showWhere(workspace_, tr("Hide"), [&organs](const document::Organ& organ) {
          return organ.look.visible && std::find(organs.begin(), organs.end(), organ.id) == organs.end();
        });
      });
  actions.add(
      "organ.showAll",
      {tr("Show &all"), "eye", {QKeySequence(QStringLiteral("Ctrl+Shift+H"))}, tr("Show every organ")},
      [this] { showWhere(workspace_, tr("Show all"), [](const document::Organ&) { return true; }); });
  actions.add("organ.find",
              {tr("&Find an organ"), nullptr, {QKeySequence::Find}, tr("Type a part of its name")}, [this] {
                search_->show();
                search_->setFocus(Qt::ShortcutFocusReason);
                search_->selectAll();
              });
  actions.add("organ.rename", {tr("Re&name organ"), "rename", {}, {}}, [this] { editName(); });
  actions.add("organ.remove", {tr("&Remove organ"), "remove", {}, {}}, [this] {
    if (const auto organs = chosen(); !organs.empty())
      remove(organs);
  });
  actions.enableWhile(
      {"organ.showOnly", "organ.hide", "organ.showAll", "organ.find", "organ.rename", "organ.remove"},
      [this] { return !workspace_.document().organs().empty(); });
  menu_->addTo(actions);
  // All selected rows decide which actions are enabled.
  connect(list_, &QTreeWidget::itemSelectionChanged, &actions, [this, &actions] {
    if (!updating_)
      actions.sync();
  });
}

/// Handles without an organ are useless, so they are removed with the last one.
void OrganPanel::remove(const std::vector<document::OrganId>& organs) {
  document::Command command = document::removeOrgans(organs);
  const document::OrganList& all = workspace_.document().organs();
  const auto goes = [&organs](document::OrganId id) {
    return std::find(organs.begin(), organs.end(), id) != organs.end();
  };
  const bool none = std::all_of(all.begin(), all.end(), [&goes](const auto& organ) {
    return goes(organ->id) || goes(organ->parent); // Cavities go with their organ, and count with it.
  });
  const auto count = static_cast<int>(std::count_if(all.begin(), all.end(), [&goes](const auto& organ) {
    return goes(organ->id) && !goes(organ->parent);
  }));
  if (!none || workspace_.document().rig().handles.empty())
    workspace_.performTelling(command, tr("%n organs removed", nullptr, count));
  else
    workspace_.performTelling(document::combined(command.name, {command, document::replaceRig({})}),
                              tr("%n organs and all handles removed", nullptr, count));
}

void OrganPanel::editName() {
  endEdit(*list_);
  const auto organ = workspace_.currentOrgan();
  if (organ && items_.count(organ->id))
    list_->editItem(items_[organ->id], kOrganName);
}

document::OrganId OrganPanel::organOf(const QTreeWidgetItem* item) const {
  return {item->data(kOrganName, Qt::UserRole).toLongLong()};
}

std::vector<document::OrganId> OrganPanel::chosen() const {
  std::vector<document::OrganId> organs;
  for (const auto& organ : workspace_.document().organs()) {
    const auto found = items_.find(organ->id);
    // Hidden rows are not included; a new organ may have no row yet.
    if (found == items_.end() || found->second->isHidden())
      continue;
    const QTreeWidgetItem* item = found->second;
    const bool bySystem =
        !systems_.empty() && item->parent() && item->parent()->isSelected() && !organOf(item->parent());
    if (item->isSelected() || bySystem)
      organs.push_back(organ->id);
  }
  if (const auto current = workspace_.currentOrgan(); organs.empty() && current)
    organs.push_back(current->id);
  return organs;
}

bool OrganPanel::sameRows() const {
  const document::OrganList& organs = workspace_.document().organs();
  const auto top = std::count_if(organs.begin(), organs.end(), [](const auto& o) { return !o->parent; });
  const bool grouped = static_cast<std::size_t>(top) > kFew;
  const auto inPlace = [&](const auto& organ) {
    const auto item = items_.find(organ->id);
    if (item == items_.end())
      return false;
    if (!grouped || organ->parent)
      return true;
    const auto system = systems_.find(anatomy::systemNamed(organ->name));
    return system != systems_.end() && item->second->parent() == system->second;
  };
  return grouped != systems_.empty() && organs.size() == items_.size() &&
         std::all_of(organs.begin(), organs.end(), inPlace);
}

QTreeWidgetItem* OrganPanel::rowUnder(QTreeWidgetItem* parent) {
  auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(list_);
  item->setTextAlignment(kOrganVolume, Qt::AlignRight | Qt::AlignVCenter);
  // All rows are as high as the first: a change has to fit also where there is none yet.
  if (!list_->rootIsDecorated())
    item->setSizeHint(kOrganEye, QSize(0, VolumeColumn::rowHeight(list_->font())));
  return item;
}

QTreeWidgetItem* OrganPanel::systemRow(const std::string& system) {
  QTreeWidgetItem*& row = systems_[system];
  if (!row) {
    row = rowUnder(nullptr);
    QFont bold = list_->font();
    bold.setBold(true);
    row->setFont(kOrganName, bold);
  }
  return row;
}

void OrganPanel::makeRows() {
  const document::OrganList& organs = workspace_.document().organs();
  const auto top = std::count_if(organs.begin(), organs.end(), [](const auto& o) { return !o->parent; });
  const bool grouped = static_cast<std::size_t>(top) > kFew;
  items_.clear();
  systems_.clear();
  list_->clear();
  list_->setRootIsDecorated(grouped);
  if (grouped) // In the order of the body's systems, not in that of a file.
    for (const std::string& system : anatomy::organSystems())
      if (std::any_of(organs.begin(), organs.end(), [&system](const auto& organ) {
            return !organ->parent && anatomy::systemNamed(organ->name) == system;
          }))
        systemRow(system);
  for (const auto& organ : organs) {
    const auto parent = items_.find(organ->parent);
    auto* item = rowUnder(parent != items_.end() ? parent->second
                          : grouped              ? systemRow(anatomy::systemNamed(organ->name))
                                                 : nullptr);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setData(kOrganName, Qt::UserRole, static_cast<qlonglong>(organ->id.value));
    items_[organ->id] = item;
  }
  list_->expandAll();
}

void OrganPanel::rebuild() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::OrganList& organs = workspace_.document().organs();
  const bool rowsStay = sameRows();
  if (!rowsStay)
    makeRows();
  for (const auto& organ : organs)
    updateRow(*organ, items_[organ->id]);
  if (rowsStay)
    updateSystems();
  else
    filter(); // By the names that the rows have only now.
  empty_->setVisible(organs.empty());
  list_->setVisible(!organs.empty());
  opacity_->setVisible(!organs.empty());
  search_->setVisible(!systems_.empty());
  if (systems_.empty())
    search_->clear(); // A hidden search field must not filter rows.
  updateVolumes();
  // Rows that stay keep their selection, so that the user can apply further actions to them.
  if (!rowsStay || list_->selectedItems().isEmpty())
    syncSelection();
  syncOpacity();
  fitNameColumn();
}

/// Hides numbers if names would be cut: a wider panel has room for both, and tooltips and the status bar show
/// the numbers too.
void OrganPanel::fitNameColumn() {
  widestVolume_ = 0;
  leaveNumbersOut();
}

/// Among many organs names are whole; among few they have some letters at least. The widest numbers count
/// that were there, so that the columns do not come and go with a beat.
void OrganPanel::leaveNumbersOut() {
  constexpr int kPadding = 12; // Around a name and its square.
  constexpr int kLetters = 8;
  const QFontMetrics metrics(list_->font());
  int widest = 0;
  int indented = 0;
  for (const auto& [id, item] : items_) {
    const int steps = item->parent() && item->parent()->parent() ? 3 : item->parent() ? 2 : 1;
    indented = std::max(indented, (steps - 1) * list_->indentation());
    widest =
        std::max(widest, steps * list_->indentation() + metrics.horizontalAdvance(item->text(kOrganName)));
    const QString change = item->data(kOrganVolume, VolumeColumn::kChangeRole).toString();
    widestVolume_ =
        std::max(widestVolume_, VolumeColumn::textWidth(list_->font(), item->text(kOrganVolume), change));
  }
  const int name =
      systems_.empty() ? std::min(widest, indented + kLetters * metrics.averageCharWidth()) : widest;
  const int room = list_->viewport()->width() - list_->columnWidth(kOrganEye) -
                   list_->columnWidth(kOrganLock) - kSwatchWidth - 2 * kPadding - widestVolume_;
  list_->setColumnHidden(kOrganVolume, name > room);
}

/// Fits the names also where a list that was hidden gets its place, or a scroll bar.
bool OrganPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_->viewport() && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &OrganPanel::fitNameColumn, Qt::QueuedConnection);
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (watched == search_ && key && handleSearchKey(static_cast<QKeyEvent&>(*event)))
    return true;
  return QWidget::eventFilter(watched, event);
}

/// Down chooses the first organ that is found; Escape, otherwise a shortcut of the window, shows all rows
/// again. Returns whether the search has taken the key.
bool OrganPanel::handleSearchKey(QKeyEvent& event) {
  const bool down = event.key() == Qt::Key_Down;
  if (!down && (event.key() != Qt::Key_Escape || search_->text().isEmpty()))
    return false;
  if (event.type() == QEvent::ShortcutOverride)
    event.accept();
  else if (down)
    chooseFirstFound();
  else
    search_->clear();
  return true;
}

bool OrganPanel::isFound(const QTreeWidgetItem* row) const {
  return row->text(kOrganName).contains(search_->text().trimmed(), Qt::CaseInsensitive);
}

void OrganPanel::chooseFirstFound() {
  for (QTreeWidgetItemIterator row(list_, QTreeWidgetItemIterator::NotHidden); *row; ++row)
    if (organOf(*row) && isFound(*row)) {
      list_->setCurrentItem(*row);
      list_->setFocus(Qt::OtherFocusReason);
      return;
    }
}

/// A system's row has the number of its organs, also of those that a search finds, and an eye for all of
/// them.
void OrganPanel::updateSystems() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  for (const auto& [system, row] : systems_) {
    int seen = 0, found = 0;
    for (int child = 0; child < row->childCount(); ++child)
      if (const auto organ = workspace_.document().organ(organOf(row->child(child)))) {
        seen += organ->look.visible;
        found += row->child(child)->isHidden() ? 0 : 1;
      }
    row->setText(kOrganName, found < row->childCount()
                                 ? tr("%1 (%2 of %3)").arg(inWords(system)).arg(found).arg(row->childCount())
                                 : QStringLiteral("%1 (%2)").arg(inWords(system)).arg(row->childCount()));
    row->setIcon(kOrganEye, icon(seen > 0 ? "eye" : "eye_off"));
    row->setToolTip(kOrganEye, seen > 0 ? tr("Hide all of them (click)") : tr("Show all of them (click)"));
  }
}

/// Shows the rows whose name contains the search text; a system without such a row is hidden.
void OrganPanel::filter() {
  for (const auto& [id, item] : items_)
    item->setHidden(!isFound(item));
  for (const auto& [id, item] : items_) // A cavity that fits shows the organ around it.
    if (!item->isHidden() && item->parent())
      item->parent()->setHidden(false);
  for (const auto& [system, row] : systems_) {
    bool any = false;
    for (int child = 0; child < row->childCount(); ++child)
      any = any || !row->child(child)->isHidden();
    row->setHidden(!any);
  }
  updateSystems();
}

void OrganPanel::updateRow(const document::Organ& organ, QTreeWidgetItem* item) {
  const QScopedValueRollback<bool> quiet(updating_, true);
  item->setText(kOrganName, inWords(presentation::labelOf(organ)));
  item->setIcon(kOrganName, swatch(asColor(presentation::shownColor(organ.look.color))));
  item->setIcon(kOrganEye, icon(organ.look.visible ? "eye" : "eye_off"));
  item->setToolTip(kOrganEye, organ.look.visible ? tr("Hide (click)") : tr("Show (click)"));
  QString tip = tr("%1\n%n triangles", nullptr, static_cast<int>(organ.mesh->triangles.rows()))
                    .arg(inWords(organ.name));
  for (const Text& warning : organ.warnings)
    tip += QStringLiteral("\n") + inWords(warning);
  updateLock(organ, item);
  item->setToolTip(kOrganName,
                   tip + tr("\nDouble click or F2 renames; a click on the square changes the colour"));
}

void OrganPanel::updateLock(const document::Organ& organ, QTreeWidgetItem* item) {
  // Only locks that are on should be conspicuous.
  const QPixmap open = icon("unlock").pixmap(kOrganIconSize, QIcon::Disabled);
  item->setIcon(kOrganLock, organ.volumeLocked ? icon("lock") : QIcon(open));
  if (!organ.closed())
    return item->setToolTip(kOrganLock,
                            tr("An open surface has no volume to lock; click to close its holes"));
  QString tip = organ.volumeLocked ? tr("The volume is locked: Deform mode keeps it (click or K to unlock)")
                                   : tr("Lock the volume (click or K)");
  const document::OrganList& all = workspace_.document().organs();
  if (std::any_of(all.begin(), all.end(), [&organ](const auto& other) { return other->parent == organ.id; }))
    tip += tr("\nThis is the volume within the outer surface; cavities have locks of their own");
  else if (organ.parent)
    tip += tr("\nThis is the volume of the cavity; the wall around it has a lock of its own");
  item->setToolTip(kOrganLock, tip);
}

void OrganPanel::updateVolumes() {
  writeVolumes();
  list_->resizeColumnToContents(kOrganVolume);
  list_->viewport()->update(list_->columnViewportPosition(kOrganVolume), 0, list_->columnWidth(kOrganVolume),
                            list_->viewport()->height());
  if (systems_.empty())
    leaveNumbersOut();
}

/// Sends no signal for each number: Qt would measure the texts of all rows at each.
void OrganPanel::writeVolumes() {
  const QSignalBlocker quiet(list_->model());
  for (const auto& organ : workspace_.document().organs()) {
    const auto found = items_.find(organ->id);
    if (found == items_.end())
      continue;
    const live::OrganVolume volume = workspace_.live().volume(organ->id);
    QTreeWidgetItem* item = found->second;
    item->setText(kOrganVolume, volume.closed ? formatMilliliters(volume.nowMl) : tr("open"));
    const bool changed = volume.closed && std::abs(volume.relativeChange()) >= kNoticed;
    const QPalette& colors = list_->palette();
    // Among many organs rows have one line, and the tip tells the change.
    const bool few = systems_.empty();
    item->setData(kOrganVolume, VolumeColumn::kChangeColorRole,
                  (organ->volumeLocked ? colors.placeholderText() : colors.link()).color());
    item->setData(kOrganVolume, VolumeColumn::kChangeRole,
                  changed && few ? formatRelativeChange(volume) : QString());
    item->setForeground(kOrganVolume, changed && !few ? colors.link() : colors.text());
    const QString tip = !volume.closed ? tr("An open surface encloses no volume")
                                       : tr("%1 at rest, %2 (%3) now")
                                             .arg(formatMilliliters(volume.restMl), formatChange(volume),
                                                  formatRelativeChange(volume));
    item->setToolTip(kOrganVolume, tip);
  }
}

void OrganPanel::syncSelection() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const auto selected = items_.find(workspace_.selection().organ());
  // Several rows may be chosen beside the current one: they stay when it is the one that it was.
  QTreeWidgetItem* wanted = selected != items_.end() ? selected->second : nullptr;
  if (list_->currentItem() != wanted)
    list_->setCurrentItem(wanted, kOrganName,
                          QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  syncOpacity();
}

void OrganPanel::syncOpacity() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  if (const auto organ = workspace_.currentOrgan())
    opacity_->setValue(100 * organ->look.opacity);
}

void OrganPanel::onClicked(QTreeWidgetItem* item, int column) {
  const document::OrganId organ = organOf(item);
  if (column == kOrganEye && !organ)
    return toggleSystem(item);
  if (column == kOrganEye) {
    changeLook(organ, [](document::OrganLook& look) { look.visible = !look.visible; });
    workspace_.undo().seal();
    return;
  }
  if (!organ)
    return;
  if (column == kOrganLock) {
    if (const auto present = workspace_.document().organ(organ))
      poses_.setLocked({organ}, !present->volumeLocked);
    return;
  }
  const QRect row = list_->visualItemRect(item);
  int left = list_->visualRect(list_->model()->index(0, kOrganName)).left();
  for (const QTreeWidgetItem* around = item->parent(); around; around = around->parent())
    left += list_->indentation();
  const QPoint place = list_->viewport()->mapFromGlobal(QCursor::pos());
  const bool onSquare = place.x() >= left && place.x() < left + kSwatchWidth && row.contains(place);
  if (column == kOrganName && onSquare)
    menu_->chooseColorOf({organ}, list_->viewport()->mapToGlobal(QPoint(left, row.bottom())));
}

void OrganPanel::onChanged(QTreeWidgetItem* item, int column) {
  if (updating_ || column != kOrganName)
    return;
  const document::OrganId id = organOf(item);
  const std::string name = item->text(kOrganName).trimmed().toStdString();
  const auto present = workspace_.document().organ(id);
  if (present && item->text(kOrganName) == inWords(presentation::labelOf(*present)))
    return; // The text that is shown as its name.
  // A name that is refused is reset.
  if (!workspace_.perform(document::renameOrgan(id, name)))
    if (const auto organ = workspace_.document().organ(id))
      updateRow(*organ, item);
}

void OrganPanel::changeLook(document::OrganId organ, const LookChange& change) {
  const auto present = workspace_.document().organ(organ);
  if (!present)
    return;
  document::OrganLook look = present->look;
  change(look);
  workspace_.perform(document::setOrganLook(organ, look));
}

void OrganPanel::toggleSystem(const QTreeWidgetItem* row) {
  std::vector<document::OrganId> organs;
  bool anySeen = false;
  for (int child = 0; child < row->childCount(); ++child) {
    organs.push_back(organOf(row->child(child)));
    const auto organ = workspace_.document().organ(organs.back());
    anySeen = anySeen || (organ && organ->look.visible);
  }
  changeLooks(workspace_, anySeen ? tr("Hide") : tr("Show"), organs,
              [anySeen](document::OrganLook& look) { look.visible = !anySeen; });
  workspace_.undo().seal();
}

void OrganPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  // Another theme: colours that were taken from the last one are taken anew.
  if (event->type() == QEvent::PaletteChange && list_) {
    for (const auto& organ : workspace_.document().organs())
      if (const auto found = items_.find(organ->id); found != items_.end())
        updateRow(*organ, found->second);
    updateVolumes();
  }
}

void OrganPanel::contextMenuEvent(QContextMenuEvent* event) {
  QTreeWidgetItem* item = list_->itemAt(list_->viewport()->mapFromGlobal(event->globalPos()));
  if (!item)
    return;
  if (!item->isSelected())
    list_->setCurrentItem(item);
  menu_->popup(event->globalPos());
}

void OrganPanel::setWaiting(bool waiting) {
  empty_->setText(
      waiting
          ? tr("The sample organ is being made.")
          : tr("No organ yet.\nOpen a file (Ctrl+O), drop one here, or take a sample organ from the menu."));
}

} // namespace viscera::app
