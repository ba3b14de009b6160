#include "window/import/import_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>

#include "window/import/organ_check.h"
#include "window/widgets/panel_dock.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

/// Worst first, so that organs to check are not below forty good ones.
std::vector<std::size_t> byUrgency(const document::ImportDraft& draft) {
  std::vector<std::size_t> order(draft.organs.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return draft.organs[a].assessment.worst() > draft.organs[b].assessment.worst();
  });
  return order;
}

/// More organs than that can be filtered, and good ones take one line.
constexpr std::size_t kMany = 6;

/// Rows of the list of findings before those that organs have in common.
enum { kEveryOrgan, kToCheck, kFirstShared };

QString summaryOf(const document::ImportDraft& draft) {
  const auto of = [&](auto severity) {
    return static_cast<int>(
        std::count_if(draft.organs.begin(), draft.organs.end(), [&](const document::DraftOrgan& organ) {
          return organ.included && organ.assessment.worst() == severity;
        }));
  };
  if (!draft.questionable())
    return ImportPanel::tr("No problems found. Nothing is in the document yet.");
  if (draft.organs.size() <= kMany)
    return ImportPanel::tr(
        "Check the findings first. Nothing is in the document yet, and no file is changed.");
  const int faults = of(medical_io::FindingSeverity::fault), doubts = of(medical_io::FindingSeverity::doubt);
  return ImportPanel::tr("%1 organs: %2 with faults, %3 to check, %4 without problems. Nothing is in the "
                         "document yet, and no file is changed.")
      .arg(draft.organs.size())
      .arg(faults)
      .arg(doubts)
      .arg(static_cast<int>(draft.organs.size()) - faults - doubts);
}

/// "Triangles that face inward: 12 of 95 organs".
QString sharedText(const document::SharedFinding& shared, const document::ImportDraft& draft) {
  if (shared.ofThePatient)
    return ImportPanel::tr("%1 of %2 organs are not life-sized; a change of unit applies to all organs from "
                           "surface files")
        .arg(shared.organs.size())
        .arg(draft.organs.size());
  return ImportPanel::tr("%1: %2 of %3 organs")
      .arg(subjectName(shared.subject))
      .arg(shared.organs.size())
      .arg(draft.organs.size());
}

} // namespace

ImportPanel::ImportPanel(QWidget* parent)
    : QWidget(parent), title_(new WrappedLabel(this)), summary_(makeRemark({}, this)), name_(new QLineEdit),
      finding_(new QComboBox), filter_(makeFilter()), organs_(new QWidget), column_(new QVBoxLayout(organs_)),
      import_(new QPushButton(tr("Import"), this)) {
  setObjectName(QStringLiteral("panel"));
  auto* whole = makeLayout<QVBoxLayout>(this, 0);
  auto* heading = makeLayout<QVBoxLayout>(nullptr, 2, {12, 8, 12, 8});
  embolden(title_, 1.1);
  heading->addWidget(title_);
  heading->addWidget(summary_);
  heading->addWidget(filter_);
  whole->addLayout(heading);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
  whole->addWidget(scrolled(organs_), 1);
  auto* buttons = makeLayout<QHBoxLayout>(nullptr, 8, {12, 8, 12, 12});
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

QWidget* ImportPanel::makeFilter() {
  auto* box = new QWidget(this);
  auto* column = makeLayout<QVBoxLayout>(box, 4, {0, 6, 0, 0});
  name_->setObjectName(QStringLiteral("importFilter"));
  name_->setPlaceholderText(tr("Find an organ"));
  name_->setClearButtonEnabled(true);
  finding_->setObjectName(QStringLiteral("importFindings"));
  finding_->setAccessibleName(tr("Organs to show, by finding"));
  auto* all = new QPushButton(tr("All"), box);
  all->setObjectName(QStringLiteral("importAll"));
  all->setToolTip(tr("Import all organs of this list"));
  auto* none = new QPushButton(tr("None"), box);
  none->setObjectName(QStringLiteral("importNone"));
  none->setToolTip(tr("Import no organ of this list"));
  column->addWidget(name_);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(finding_, 1);
  row->addWidget(all);
  row->addWidget(none);
  column->addLayout(row);
  connect(name_, &QLineEdit::textChanged, this, &ImportPanel::filter);
  connect(finding_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ImportPanel::filter);
  connect(all, &QPushButton::clicked, this, [this] { includeShown(true); });
  connect(none, &QPushButton::clicked, this, [this] { includeShown(false); });
  return box;
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
  if (title_->text() != title)
    name_->clear();
  title_->setText(title);
  summary_->setText(summaryOf(draft));
  cards_.clear();
  shared_ = document::sharedFindings(draft);
  addCommon(draft);
  for (const std::size_t place : byUrgency(draft))
    addOrgan(draft, place);
  column_->addStretch(1);
  const auto taken = std::count_if(draft.organs.begin(), draft.organs.end(),
                                   [](const auto& organ) { return organ.included; });
  const bool whole = taken == static_cast<std::ptrdiff_t>(draft.organs.size());
  import_->setText(!whole                 ? tr("Import %n organs", nullptr, static_cast<int>(taken))
                   : draft.questionable() ? tr("Import as it is")
                                          : tr("Import"));
  import_->setProperty("quiet", draft.questionable());
  import_->style()->unpolish(import_);
  import_->style()->polish(import_);
  fillFindings();
  filter_->setVisible(draft.organs.size() > kMany);
  filter();
  setBusy(false);
  import_->setEnabled(!draft.empty());
}

/// Findings that several organs share are listed once above the organs, with the repairs that help all of
/// them.
void ImportPanel::addCommon(const document::ImportDraft& draft) {
  std::vector<std::size_t> all(draft.organs.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  std::vector<std::pair<medical_io::Finding, std::vector<std::size_t>>> lines;
  if (draft.arrangement)
    lines.emplace_back(*draft.arrangement, all);
  const bool unitShared =
      std::any_of(shared_.begin(), shared_.end(), [](const auto& shared) { return shared.ofThePatient; });
  if (draft.size && !unitShared)
    lines.emplace_back(*draft.size, all);
  for (const document::SharedFinding& shared : shared_)
    lines.emplace_back(medical_io::Finding{shared.severity, sharedText(shared, draft).toStdString(),
                                           shared.repairs, shared.subject},
                       shared.repairable);
  if (lines.empty())
    return;
  auto* frame = new QFrame(organs_);
  frame->setObjectName(QStringLiteral("organCheck"));
  auto* column = makeLayout<QVBoxLayout>(frame, -1, {12, 8, 12, 8});
  auto* heading = new QLabel(tr("All organs together"), frame);
  embolden(heading);
  column->addWidget(heading);
  for (const auto& [finding, repairable] : lines) {
    auto* line = new FindingLine(finding, frame);
    column->addWidget(line);
    connect(line, &FindingLine::repairRequested, this, [this, organs = repairable](const QString& id) {
      Q_EMIT repairRequested(organs, id.toStdString());
    });
  }
  column_->addWidget(frame);
}

void ImportPanel::addOrgan(const document::ImportDraft& draft, std::size_t place) {
  const bool severalFiles =
      std::any_of(draft.organs.begin(), draft.organs.end(),
                  [&](const document::DraftOrgan& organ) { return organ.file != draft.organs.front().file; });
  const bool sizeSaid =
      std::any_of(shared_.begin(), shared_.end(), [](const auto& shared) { return shared.ofThePatient; });
  OrganCheck::Detail detail;
  detail.file = severalFiles;
  detail.size = !sizeSaid;
  detail.brief = draft.organs.size() > kMany;
  auto* check = new OrganCheck(draft.organs[place], detail, organs_);
  connect(check, &OrganCheck::repairRequested, this,
          [this, place](const QString& id) { Q_EMIT repairRequested({place}, id.toStdString()); });
  connect(check, &OrganCheck::previewRequested, this,
          [this, place](const QString& id) { Q_EMIT previewRequested(place, id.toStdString()); });
  connect(check, &OrganCheck::revertRequested, this, [this, place] { Q_EMIT revertRequested(place); });
  connect(check, &OrganCheck::includedChanged, this,
          [this, place](bool included) { Q_EMIT includedChanged({place}, included); });
  column_->addWidget(check);
  cards_.push_back(
      {place, OrganCheck::shownName(draft.organs[place]) + QLatin1Char(' ') + text(draft.organs[place].name),
       draft.organs[place].assessment.questionable(), check});
}

/// The selection is kept if it still exists.
void ImportPanel::fillFindings() {
  const QSignalBlocker quiet(finding_);
  const QVariant chosen = finding_->currentData();
  finding_->clear();
  finding_->addItem(tr("Every organ"), -2);
  finding_->addItem(tr("To check"), -1);
  for (const document::SharedFinding& shared : shared_)
    finding_->addItem(
        tr("%1 (%2)").arg(subjectName(shared.subject)).arg(static_cast<int>(shared.organs.size())),
        static_cast<int>(shared.subject));
  finding_->setCurrentIndex(std::max(finding_->findData(chosen), 0));
}

void ImportPanel::filter() {
  const QString name = filter_->isHidden() ? QString() : name_->text().trimmed();
  const int row = filter_->isHidden() ? kEveryOrgan : finding_->currentIndex();
  for (const Card& card : cards_) {
    bool wanted = card.name.contains(name, Qt::CaseInsensitive);
    if (row == kToCheck)
      wanted = wanted && card.questionable;
    if (row >= kFirstShared) {
      const auto& organs = shared_[static_cast<std::size_t>(row - kFirstShared)].organs;
      wanted = wanted && std::count(organs.begin(), organs.end(), card.organ) > 0;
    }
    card.check->setVisible(wanted);
  }
}

void ImportPanel::includeShown(bool included) {
  std::vector<std::size_t> organs;
  for (const Card& card : cards_)
    if (!card.check->isHidden())
      organs.push_back(card.organ);
  Q_EMIT includedChanged(organs, included);
}

void ImportPanel::setBusy(bool busy) {
  organs_->setEnabled(!busy);
  filter_->setEnabled(!busy);
  import_->setEnabled(!busy);
}

} // namespace viscera::app
