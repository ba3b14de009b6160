#include "window/handles/handle_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "viscera/presentation/presenter.h"
#include "window/style/language.h"
#include "window/widgets/wrapped_label.h"
#include "window/work/actions.h"

namespace viscera::app {

HandleTable::HandleTable(Workspace& workspace, PoseEditor& poses, const Picture& picture, ViewWidget& view,
                         QWidget* parent)
    : QDialog(parent), workspace_(workspace), picture_(picture), view_(view), model_(workspace, poses),
      sorted_(new QSortFilterProxyModel(this)), table_(new QTableView(this)),
      vertex_(new WrappedLabel(this)) {
  setWindowTitle(tr("Table of handles"));
  setObjectName(QStringLiteral("handleTable"));
  resize(760, 480);
  sorted_->setSourceModel(&model_);
  sorted_->setSortRole(Qt::EditRole);
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(-1, Qt::AscendingOrder); // In the order of the rig.
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setAccessibleName(tr("Table of handles"));
  vertex_->setObjectName(QStringLiteral("handleTableVertex"));
  vertex_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* copying = new QPushButton(tr("&Copy"), this);
  copying->setToolTip(tr("Copy the selected rows, or all, with all digits (Ctrl+C)"));
  copying->setAutoDefault(false);
  auto* column = new QVBoxLayout(this);
  column->addWidget(table_);
  column->addWidget(vertex_);
  column->addWidget(copying, 0, Qt::AlignRight);
  connect(copying, &QPushButton::clicked, this, &HandleTable::copy);
  connect(new QShortcut(QKeySequence::Copy, table_, nullptr, nullptr, Qt::WidgetShortcut),
          &QShortcut::activated, this, &HandleTable::copy);
  connect(&view, &ViewWidget::clicked, this, &HandleTable::onClick);
  connect(&model_, &HandleModel::weightsChanged, this, &HandleTable::sayVertex);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &HandleTable::selectInDocument);
  sayVertex();
}

void HandleTable::addTo(Actions& actions) {
  actions.add("handles.table",
              {tr("&Table of handles..."),
               "handles",
               {tr("Ctrl+Shift+T")},
               tr("Positions of all handles, and the coordinates of a vertex that you click")},
              [this] {
                show();
                raise();
                activateWindow();
              });
  actions.enableWhile({"handles.table"}, [this] { return !workspace_.document().rig().handles.empty(); });
}

void HandleTable::onClick(const QPointF& place) {
  if (!isVisible())
    return;
  if (const auto pick = view_.pickNear(place))
    model_.showVertex(ShownVertex{picture_.organOf(pick->organ), pick->vertex});
}

void HandleTable::sayVertex() {
  const auto& vertex = model_.shownVertex();
  const auto organ = vertex ? workspace_.document().organ(vertex->organ) : nullptr;
  if (!organ)
    return vertex_->setText(tr("Click the organ in the view to see the coordinates of its nearest vertex."));
  const Vec3 at = organ->mesh->points.row(vertex->vertex).transpose();
  const QString where = tr("Vertex %1 of %2, at rest at %3, %4, %5 mm (LPS)")
                            .arg(vertex->vertex)
                            .arg(inWords(presentation::labelOf(*organ)))
                            .arg(formatNumber(at.x(), 2))
                            .arg(formatNumber(at.y(), 2))
                            .arg(formatNumber(at.z(), 2));
  const Values& weights = model_.weights();
  if (weights.size() == 0)
    return vertex_->setText(tr("%1: the organ is not bound to the handles.").arg(where));
  const Vec3 made = workspace_.document().rig().restPositions().transpose() * weights;
  vertex_->setText(tr("%1. Its coordinates sum to %2 and miss it by %3 mm.")
                       .arg(where)
                       .arg(formatNumber(weights.sum(), 9))
                       .arg(formatDigits((made - at).norm(), 2)));
}

void HandleTable::selectInDocument() {
  std::vector<document::HandleId> handles;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows())
    handles.push_back(
        workspace_.document().rig().handles[static_cast<std::size_t>(sorted_->mapToSource(row).row())].id);
  if (!handles.empty())
    workspace_.selection().setHandles(handles);
}

void HandleTable::copy() const {
  const QModelIndexList selected = table_->selectionModel()->selectedRows();
  std::vector<int> rows;
  for (int shown = 0; shown < sorted_->rowCount(); ++shown) {
    const QModelIndex row = sorted_->index(shown, 0);
    if (selected.empty() || selected.contains(row))
      rows.push_back(sorted_->mapToSource(row).row());
  }
  QGuiApplication::clipboard()->setText(model_.textOf(rows));
}

} // namespace viscera::app
