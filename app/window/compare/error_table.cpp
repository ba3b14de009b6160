#include "window/compare/error_table.h"

#include <QGridLayout>
#include <QLabel>

#include <utility>

#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {

ErrorTable::ErrorTable(Workspace& first, Workspace& second, QWidget* parent)
    : QWidget(parent), first_(first) {
  auto* grid = makeLayout<QGridLayout>(this, 8, {12, 8, 12, 8});
  grid->setHorizontalSpacing(20);
  const std::array<std::pair<QString, QString>, kRows> rows = {
      {{tr("Rest error"), tr("The largest distance of the bound organ at rest from the original")},
       {tr("Unity error"), tr("The largest distance of a vertex's weights' sum from 1")},
       {tr("Smallest weight"), tr("Negative where the system is not positive")},
       {tr("Failures"), tr("Vertices for which the system has no coordinates; they do not move")},
       {tr("Binding time"), QString()}}};
  for (std::size_t row = 0; row < kRows; ++row) {
    auto* name = new QLabel(rows[row].first, this);
    name->setToolTip(rows[row].second);
    grid->addWidget(name, static_cast<int>(row) + 1, 0);
  }
  addColumn(first, 0);
  addColumn(second, 1);
  for (Workspace* workspace : {&first, &second}) {
    subscriptions_.push_back(workspace->onChange([this](const document::Change& change) {
      if (change.organs() || change.system())
        refresh();
    }));
    subscriptions_.push_back(workspace->live().onEvent([this](const live::LiveEvent& event) {
      if (event.status)
        refresh();
    }));
  }
  subscriptions_.push_back(first.selection().onChange([this] { refresh(); }));
  refresh();
}

void ErrorTable::addColumn(Workspace& workspace, int place) {
  auto* grid = static_cast<QGridLayout*>(layout());
  Column column{&workspace, new QLabel(this), {}};
  QFont bold = column.title->font();
  bold.setBold(true);
  column.title->setFont(bold);
  column.title->setObjectName(QStringLiteral("errors/%1/title").arg(place));
  grid->addWidget(column.title, 0, place + 1, Qt::AlignRight);
  for (std::size_t row = 0; row < kRows; ++row) {
    column.cells[row] = new QLabel(this);
    column.cells[row]->setObjectName(QStringLiteral("errors/%1/%2").arg(place).arg(row));
    column.cells[row]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(column.cells[row], static_cast<int>(row) + 1, place + 1, Qt::AlignRight);
  }
  columns_.push_back(column);
}

void ErrorTable::refresh() {
  constexpr int kDigits = 2;
  const auto organ = first_.currentOrgan();
  for (const Column& column : columns_) {
    Workspace& workspace = *column.workspace;
    const std::string& id = workspace.document().system().id;
    column.title->setText(workspace.registry().contains(id) ? inWords(workspace.registry().find(id)->name())
                                                            : text(id));
    // The second document may be about to hear of an organ that the first has.
    const live::BindingStatus status = organ && workspace.document().organ(organ->id)
                                           ? workspace.live().status(organ->id)
                                           : live::BindingStatus();
    if (status.state != live::BindingStatus::State::bound) {
      for (QLabel* cell : column.cells)
        cell->setText(QStringLiteral("-"));
      continue;
    }
    const coordinates::BindingReport& report = status.report;
    column.cells[0]->setText(tr("%1 mm").arg(formatDigits(report.identityError, kDigits)));
    column.cells[1]->setText(formatDigits(report.unityError, kDigits));
    column.cells[2]->setText(formatDigits(report.minWeight, kDigits));
    column.cells[3]->setText(locale().toString(static_cast<qulonglong>(report.failures.size())));
    column.cells[4]->setText(tr("%1 ms").arg(formatNumber(1000 * report.seconds, 1)));
  }
}

} // namespace viscera::app
