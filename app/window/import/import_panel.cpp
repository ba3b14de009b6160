#include "window/import/import_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

#include "window/import/organ_check.h"
#include "window/widgets/panel_dock.h"
#include "window/widgets/ready_made.h"
#include "window/workspace.h"

namespace viscera::app {
namespace {

/// Worst first, so that what needs a look is not below forty good ones.
std::vector<std::size_t> byUrgency(const document::ImportDraft& draft) {
  std::vector<std::size_t> order(draft.organs.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return draft.organs[a].assessment.worst() > draft.organs[b].assessment.worst();
  });
  return order;
}

} // namespace

ImportPanel::ImportPanel(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), summary_(makeRemark({}, this)), organs_(new QWidget),
      column_(new QVBoxLayout(organs_)), import_(new QPushButton(tr("Import"), this)) {
  setObjectName(QStringLiteral("panel"));
  auto* whole = makeLayout<QVBoxLayout>(this, 0);
  auto* heading = makeLayout<QVBoxLayout>(nullptr, 2, {12, 8, 12, 8});
  embolden(title_, 1.1);
  title_->setWordWrap(true);
  heading->addWidget(title_);
  heading->addWidget(summary_);
  whole->addLayout(heading);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
  whole->addWidget(scrolled(organs_), 1);
  auto* buttons = makeLayout<QHBoxLayout>(nullptr, -1, {12, 8, 12, 12});
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName(QStringLiteral("cancelImport"));
  import_->setObjectName(QStringLiteral("primary"));
  buttons->addStretch(1);
  buttons->addWidget(cancel);
  buttons->addWidget(import_);
  whole->addLayout(buttons);
  connect(cancel, &QPushButton::clicked, this, &ImportPanel::cancelled);
  connect(import_, &QPushButton::clicked, this, &ImportPanel::accepted);
}

void ImportPanel::showDraft(const document::ImportDraft& draft, const QString& title) {
  while (QLayoutItem* item = column_->takeAt(0)) {
    // Not at once: it may be the one whose button was pressed.
    if (QWidget* widget = item->widget()) {
      widget->hide();
      widget->deleteLater();
    }
    delete item;
  }
  title_->setText(title);
  summary_->setText(draft.questionable()
                        ? tr("Look at this first. Nothing is in the document yet, and no file is changed.")
                        : tr("Nothing speaks against it. Nothing is in the document yet."));
  const bool severalFiles =
      std::any_of(draft.organs.begin(), draft.organs.end(),
                  [&](const document::DraftOrgan& organ) { return organ.file != draft.organs.front().file; });
  addArrangement(draft);
  for (const std::size_t place : byUrgency(draft))
    addOrgan(draft.organs[place], place, severalFiles);
  column_->addStretch(1);
  import_->setText(draft.questionable() ? tr("Import as it is") : tr("Import"));
  setBusy(false);
  import_->setEnabled(!draft.empty());
}

void ImportPanel::addArrangement(const document::ImportDraft& draft) {
  if (!draft.arrangement)
    return;
  auto* frame = new QFrame(organs_);
  frame->setObjectName(QStringLiteral("organCheck"));
  auto* column = makeLayout<QVBoxLayout>(frame, -1, {12, 8, 12, 8});
  auto* heading = new QLabel(tr("All organs together"), frame);
  embolden(heading);
  column->addWidget(heading);
  auto* line = new FindingLine(*draft.arrangement, frame);
  column->addWidget(line);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < draft.organs.size(); ++i)
    all.push_back(i);
  connect(line, &FindingLine::repairRequested, this,
          [this, all](const QString& id) { Q_EMIT repairRequested(all, id.toStdString()); });
  column_->addWidget(frame);
}

void ImportPanel::addOrgan(const document::DraftOrgan& organ, std::size_t place, bool severalFiles) {
  auto* check = new OrganCheck(organ, severalFiles, organs_);
  connect(check, &OrganCheck::repairRequested, this,
          [this, place](const QString& id) { Q_EMIT repairRequested({place}, id.toStdString()); });
  connect(check, &OrganCheck::revertRequested, this, [this, place] { Q_EMIT revertRequested(place); });
  connect(check, &OrganCheck::includedChanged, this,
          [this, place](bool included) { Q_EMIT includedChanged(place, included); });
  column_->addWidget(check);
}

void ImportPanel::setBusy(bool busy) {
  organs_->setEnabled(!busy);
  import_->setEnabled(!busy);
}

} // namespace viscera::app
