#include "window/measure/resection_box.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "viscera/presentation/presenter.h"
#include "viscera/presentation/resection.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

enum ResectionColumn { kResectionOrgan, kResectionStays, kResectionGone, kResectionColumns };
constexpr int kResectionMilliseconds = 100;
constexpr int kResectionRowsShown = 8;

} // namespace

ResectionBox::ResectionBox(Workspace& workspace, const ViewModel& view, QWidget* parent)
    : QWidget(parent), workspace_(workspace), view_(view), list_(new QTreeWidget(this)) {
  makeLayout<QVBoxLayout>(this)->addWidget(list_);
  list_->setObjectName(QStringLiteral("resectionList"));
  list_->setAccessibleName(tr("Volumes on both sides of the cut"));
  list_->setColumnCount(kResectionColumns);
  list_->setHeaderLabels({tr("Organ"), tr("Stays"), tr("Cut away")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setToolTip(tr("The volumes of the visible, closed organs on both sides of the plane, in this pose"));
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(kResectionOrgan, QHeaderView::Stretch);
  for (const int column : {kResectionStays, kResectionGone}) {
    list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    list_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  soon_.setSingleShot(true);
  soon_.setInterval(kResectionMilliseconds);
  connect(&soon_, &QTimer::timeout, this, &ResectionBox::sync);
  connect(&view, &ViewModel::changed, this, [this] {
    if (std::exchange(cut_, view_.state().cut) != view_.state().cut)
      outdated();
  });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      outdated();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent&) { outdated(); }));
  sync();
}

void ResectionBox::outdated() {
  if (!soon_.isActive() && (cut_.on || !list_->isHidden()))
    soon_.start();
}

void ResectionBox::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  sync();
}

void ResectionBox::sync() {
  cut_ = view_.state().cut;
  std::vector<presentation::Resected> found;
  if (cut_.on && isVisible())
    found = presentation::resected(cut_, workspace_.state(), [this](document::OrganId id) -> const Points& {
      return workspace_.live().points(id);
    });
  const int rows = static_cast<int>(found.size());
  while (list_->topLevelItemCount() > rows)
    delete list_->takeTopLevelItem(rows);
  while (list_->topLevelItemCount() < rows)
    list_->addTopLevelItem(new QTreeWidgetItem);
  for (int row = 0; row < rows; ++row) {
    const presentation::Resected& one = found[static_cast<std::size_t>(row)];
    QTreeWidgetItem* item = list_->topLevelItem(row);
    item->setText(kResectionOrgan, inWords(presentation::labelOf(*workspace_.document().organ(one.organ))));
    item->setText(kResectionStays, formatMilliliters(one.staysMl));
    item->setText(kResectionGone, formatMilliliters(one.cutAwayMl));
    const QString face = tr("Cut face %1 cm\u00b2").arg(formatNumber(one.faceCm2, 1));
    for (int column = 0; column < kResectionColumns; ++column)
      item->setToolTip(column, face);
    for (const int column : {kResectionStays, kResectionGone})
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  const int rowHeight = rows > 0 ? list_->sizeHintForRow(0) : 0;
  list_->setFixedHeight(list_->header()->sizeHint().height() +
                        std::min(rows, kResectionRowsShown) * rowHeight + 2 * list_->frameWidth() + 2);
  list_->setVisible(rows > 0);
}

} // namespace viscera::app
