#include "window/panels/organ_panel.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "viscera/document/organ_commands.h"
#include "window/panels/color_palette.h"
#include "window/style/icon.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/value_slider.h"

namespace viscera::app {
namespace {

enum Column { kEye, kName, kVolume, kChange, kLock, kColumns };
constexpr int kSwatchWidth = 24;
/// A change above this is shown in the accent's colour, relative.
constexpr double kNoticed = 5e-4;
constexpr double kSmall = 0.85;
constexpr int kRowMargin = 2;
constexpr int kIconSize = 16;

QTreeWidget* makeList(QWidget* parent) {
  auto* list = new QTreeWidget(parent);
  list->setObjectName(QStringLiteral("organList"));
  list->setColumnCount(kColumns);
  list->setHeaderHidden(true);
  list->setTreePosition(kName);
  list->setIndentation(14);
  list->setRootIsDecorated(false);
  list->setItemsExpandable(false);
  list->setUniformRowHeights(true);
  list->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->header()->setStretchLastSection(false);
  list->header()->setMinimumSectionSize(24);
  list->header()->setSectionResizeMode(kEye, QHeaderView::Fixed);
  list->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  list->header()->setSectionResizeMode(kVolume, QHeaderView::ResizeToContents);
  list->header()->setSectionResizeMode(kChange, QHeaderView::ResizeToContents);
  list->header()->setSectionResizeMode(kLock, QHeaderView::Fixed);
  list->setColumnWidth(kEye, 32);
  list->setColumnWidth(kLock, 30);
  list->setMinimumHeight(84);
  return list;
}

} // namespace

OrganPanel::OrganPanel(Workspace& workspace, PoseEditor& poses, VolumeMonitor& volumes, QWidget* parent)
    : QWidget(parent), workspace_(workspace), poses_(poses), list_(makeList(this)),
      empty_(makeRemark({}, this)), opacity_(new ValueSlider(tr("Opacity"), {0, 100, 1, 0, tr(" %")}, this)) {
  setObjectName(QStringLiteral("panel"));
  auto* column = makeLayout<QVBoxLayout>(this, 4, {0, 4, 0, 8});
  empty_->setText(
      tr("No organ yet.\nOpen a file (Ctrl+O), drop one here, or take a sample organ from the menu."));
  empty_->setContentsMargins(12, 8, 12, 8);
  column->addWidget(empty_);
  column->addWidget(list_, 1);
  auto* inset = makeLayout<QVBoxLayout>(nullptr, -1, {12, 0, 12, 0});
  inset->addWidget(opacity_);
  column->addLayout(inset);
  connect(list_, &QTreeWidget::itemClicked, this, &OrganPanel::onClicked);
  connect(list_, &QTreeWidget::itemChanged, this, &OrganPanel::onChanged);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int clicked) {
    if (clicked == kName)
      list_->editItem(item, kName);
  });
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!updating_ && item)
      workspace_.selection().setOrgan(organOf(item));
  });
  connect(opacity_, &ValueSlider::valueChanged, this, [this](double percent) {
    if (const auto organ = workspace_.currentOrgan())
      changeLook(organ->id, [percent](document::OrganLook& look) { look.opacity = percent / 100; });
  });
  connect(opacity_, &ValueSlider::valueChosen, this, [this] { workspace_.undo().seal(); });
  connect(&volumes, &VolumeMonitor::updated, this, &OrganPanel::updateVolumes);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      rebuild();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncSelection(); }));
  rebuild();
}

void OrganPanel::addTo(Actions& actions) {
  actions.add("organ.rename", {tr("Re&name organ"), "rename", {}, {}}, [this] { editName(); });
  actions.add("organ.remove", {tr("&Remove organ"), "remove", {}, {}}, [this] {
    if (const auto organ = workspace_.currentOrgan())
      workspace_.perform(document::removeOrgans({organ->id}));
  });
  actions.enableWhile({"organ.rename", "organ.remove"},
                      [this] { return !workspace_.document().organs().empty(); });
}

void OrganPanel::editName() {
  const auto organ = workspace_.currentOrgan();
  if (organ && items_.count(organ->id))
    list_->editItem(items_[organ->id], kName);
}

document::OrganId OrganPanel::organOf(const QTreeWidgetItem* item) const {
  return {item->data(kName, Qt::UserRole).toLongLong()};
}

void OrganPanel::rebuild() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const document::OrganList& organs = workspace_.document().organs();
  const bool sameRows =
      organs.size() == items_.size() &&
      std::all_of(organs.begin(), organs.end(), [&](const auto& o) { return items_.count(o->id); });
  if (!sameRows) {
    items_.clear();
    list_->clear();
    for (const auto& organ : organs) {
      const auto parent = items_.find(organ->parent);
      auto* item = parent != items_.end() ? new QTreeWidgetItem(parent->second) : new QTreeWidgetItem(list_);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      item->setData(kName, Qt::UserRole, static_cast<qlonglong>(organ->id.value));
      item->setTextAlignment(kVolume, Qt::AlignRight | Qt::AlignVCenter);
      item->setTextAlignment(kChange, Qt::AlignRight | Qt::AlignVCenter);
      QFont small = list_->font();
      small.setPointSizeF(kSmall * small.pointSizeF());
      item->setFont(kChange, small);
      // All rows are as high as the first: two small lines have to fit also where there is none yet.
      item->setSizeHint(kEye, QSize(0, 2 * QFontMetrics(small).lineSpacing() + kRowMargin));
      items_[organ->id] = item;
    }
    list_->expandAll();
  }
  for (const auto& organ : organs)
    updateRow(*organ, items_[organ->id]);
  empty_->setVisible(organs.empty());
  list_->setVisible(!organs.empty());
  opacity_->setVisible(!organs.empty());
  updateVolumes();
  syncSelection();
}

void OrganPanel::updateRow(const document::Organ& organ, QTreeWidgetItem* item) {
  const QScopedValueRollback<bool> quiet(updating_, true);
  item->setText(kName, text(organ.name));
  item->setIcon(kName, swatch(asColor(organ.look.color)));
  item->setIcon(kEye, icon(organ.look.visible ? "eye" : "eye_off"));
  item->setToolTip(kEye, organ.look.visible ? tr("Hide (click)") : tr("Show (click)"));
  QString tip = tr("%1\n%n {triangle|triangles}", nullptr, static_cast<int>(organ.mesh->triangles.rows()))
                    .arg(text(organ.name));
  for (const std::string& warning : organ.warnings)
    tip += QStringLiteral("\n") + text(warning);
  updateLock(organ, item);
  item->setToolTip(kName, tip + tr("\nDouble click or F2 renames; a click on the square changes the colour"));
}

void OrganPanel::updateLock(const document::Organ& organ, QTreeWidgetItem* item) {
  // Only what is locked is to catch the eye.
  const QPixmap open = icon("unlock").pixmap(kIconSize, QIcon::Disabled);
  item->setIcon(kLock, organ.volumeLocked ? icon("lock") : QIcon(open));
  if (!organ.closed())
    return item->setToolTip(kLock, tr("An open surface has no volume that could be locked; a click offers to "
                                      "close it"));
  QString tip = organ.volumeLocked
                    ? tr("The volume is locked: nothing in Deform mode changes it (click or K)")
                    : tr("Lock the volume (click or K)");
  const document::OrganList& all = workspace_.document().organs();
  if (std::any_of(all.begin(), all.end(), [&organ](const auto& other) { return other->parent == organ.id; }))
    tip += tr("\nThis is the volume within the outer surface; cavities have locks of their own");
  else if (organ.parent)
    tip += tr("\nThis is the volume of the cavity; the wall around it has a lock of its own");
  item->setToolTip(kLock, tip);
}

void OrganPanel::updateVolumes() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  for (const auto& organ : workspace_.document().organs()) {
    const auto found = items_.find(organ->id);
    if (found == items_.end())
      continue;
    const live::OrganVolume volume = workspace_.live().volume(organ->id);
    QTreeWidgetItem* item = found->second;
    item->setText(kVolume, volume.closed ? formatMilliliters(volume.nowMl) : tr("open"));
    const bool changed = volume.closed && std::abs(volume.relativeChange()) >= kNoticed;
    item->setText(kChange, changed ? formatChange(volume) + QLatin1Char('\n') + formatRelativeChange(volume)
                                   : QString());
    const QPalette& colors = list_->palette();
    item->setForeground(kChange, organ->volumeLocked ? colors.placeholderText() : colors.link());
    const QString tip = !volume.closed ? tr("An open surface encloses no volume")
                                       : tr("%1 at rest, %2 (%3) now")
                                             .arg(formatMilliliters(volume.restMl), formatChange(volume),
                                                  formatRelativeChange(volume));
    item->setToolTip(kVolume, tip);
    item->setToolTip(kChange, tip);
  }
}

void OrganPanel::syncSelection() {
  const QScopedValueRollback<bool> quiet(updating_, true);
  const auto selected = items_.find(workspace_.selection().organ());
  list_->setCurrentItem(selected != items_.end() ? selected->second : nullptr);
  if (const auto organ = workspace_.currentOrgan())
    opacity_->setValue(100 * organ->look.opacity);
}

void OrganPanel::onClicked(QTreeWidgetItem* item, int column) {
  const document::OrganId organ = organOf(item);
  if (column == kEye) {
    changeLook(organ, [](document::OrganLook& look) { look.visible = !look.visible; });
    workspace_.undo().seal();
    return;
  }
  if (column == kLock) {
    if (const auto present = workspace_.document().organ(organ))
      poses_.setLocked(organ, !present->volumeLocked);
    return;
  }
  const QRect row = list_->visualItemRect(item);
  const int left =
      list_->visualRect(list_->model()->index(0, kName)).left() + (item->parent() ? list_->indentation() : 0);
  const QPoint place = list_->viewport()->mapFromGlobal(QCursor::pos());
  if (column == kName && place.x() < left + kSwatchWidth && row.contains(place))
    chooseColorOf(organ, list_->viewport()->mapToGlobal(QPoint(left, row.bottom())));
}

void OrganPanel::onChanged(QTreeWidgetItem* item, int column) {
  if (updating_ || column != kName)
    return;
  const document::OrganId id = organOf(item);
  // A name that is refused goes back to what it was.
  if (!workspace_.perform(document::renameOrgan(id, item->text(kName).trimmed().toStdString())))
    if (const auto organ = workspace_.document().organ(id))
      updateRow(*organ, item);
}

void OrganPanel::changeLook(document::OrganId organ,
                            const std::function<void(document::OrganLook&)>& change) {
  const auto present = workspace_.document().organ(organ);
  if (!present)
    return;
  document::OrganLook look = present->look;
  change(look);
  workspace_.perform(document::setOrganLook(organ, look));
}

void OrganPanel::chooseColorOf(document::OrganId organ, const QPoint& globalPlace) {
  const auto present = workspace_.document().organ(organ);
  if (!present)
    return;
  chooseColor(
      this, globalPlace, asColor(present->look.color),
      [this, organ](const QColor& color) {
        changeLook(organ, [&](document::OrganLook& look) {
          look.color = asVec3(color);
          look.vertexColors = false;
        });
      },
      [this] { workspace_.undo().seal(); });
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
  const document::OrganId organ = organOf(item);
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  connect(menu->addAction(icon("focus"), tr("Focus")), &QAction::triggered, this,
          [this, organ] { Q_EMIT focusRequested(organ); });
  connect(menu->addAction(icon("rename"), tr("Rename")), &QAction::triggered, this,
          [this, item] { list_->editItem(item, kName); });
  connect(menu->addAction(icon("influence"), tr("Colour...")), &QAction::triggered, this,
          [this, organ, place = event->globalPos()] { chooseColorOf(organ, place); });
  const auto present = workspace_.document().organ(organ);
  if (present && present->mesh->colors.rows() > 0 && !present->look.vertexColors)
    connect(menu->addAction(tr("The organ's own colours")), &QAction::triggered, this, [this, organ] {
      changeLook(organ, [](document::OrganLook& look) { look.vertexColors = true; });
      workspace_.undo().seal();
    });
  if (present)
    connect(menu->addAction(icon(present->volumeLocked ? "unlock" : "lock"),
                            present->volumeLocked ? tr("Unlock volume") : tr("Lock volume")),
            &QAction::triggered, this,
            [this, organ, lock = !present->volumeLocked] { poses_.setLocked(organ, lock); });
  menu->addSeparator();
  connect(menu->addAction(icon("remove"), tr("Remove organ")), &QAction::triggered, this,
          [this, organ] { workspace_.perform(document::removeOrgans({organ})); });
  menu->popup(event->globalPos());
}

} // namespace viscera::app
