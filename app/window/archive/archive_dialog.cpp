#include "window/archive/archive_dialog.h"

#include <QComboBox>
#include <QDate>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

#include "window/archive/archive_client.h"
#include "window/archive/connection_dialog.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

/// Columns of the list: of studies, and below them of their series.
enum Column { kPatient, kPatientId, kDate, kModality, kDescription, kImages, kColumns };
constexpr int kStudyUid = Qt::UserRole, kSeriesUid = Qt::UserRole + 1, kImageCount = Qt::UserRole + 2;
constexpr const char* kModalities[] = {"CT", "MR", "US", "XA", "PT", "NM", "SEG", "RTSTRUCT"};
constexpr double kPerMille = 1000;

/// "Doe^Jane" as a list shows it.
QString patientShown(const std::string& name) {
  QString shown = text(name);
  const int family = shown.indexOf(QLatin1Char('^'));
  if (family >= 0)
    shown.replace(family, 1, QStringLiteral(", "));
  return shown.replace(QLatin1Char('^'), QLatin1Char(' ')).trimmed();
}

/// What DICOM matches: a beginning is enough, and the comma stands between family and given name.
std::string asPattern(QString typed) {
  typed = typed.trimmed();
  if (typed.isEmpty())
    return {};
  const int comma = typed.indexOf(QLatin1Char(','));
  if (comma >= 0)
    typed = typed.left(comma).trimmed() + QLatin1Char('^') + typed.mid(comma + 1).trimmed();
  if (!typed.endsWith(QLatin1Char('*')))
    typed += QLatin1Char('*');
  return typed.toStdString();
}

/// "20240301" of "2024-03-01" and the like; empty for nothing, none for what is no day.
std::optional<std::string> asDay(const QString& typed) {
  QString digits = typed.trimmed();
  if (digits.isEmpty())
    return std::string();
  digits.remove(QLatin1Char('-'));
  const QDate day = QDate::fromString(digits, QStringLiteral("yyyyMMdd"));
  return day.isValid() ? std::optional(digits.toStdString()) : std::nullopt;
}

QString shownDay(const std::string& day) {
  const QDate date = QDate::fromString(text(day), QStringLiteral("yyyyMMdd"));
  return date.isValid() ? date.toString(Qt::ISODate) : text(day);
}

QPushButton* makeDialogButton(const QString& title, const QString& tip, const char* name) {
  auto* button = new QPushButton(title);
  button->setToolTip(tip);
  button->setObjectName(QLatin1String(name));
  button->setAutoDefault(false);
  return button;
}

QLineEdit* makeField(const QString& tip, const char* name) {
  auto* field = new QLineEdit;
  field->setToolTip(tip);
  field->setObjectName(QLatin1String(name));
  return field;
}

} // namespace

/// An answer may be on its way while the dialog is closed.
template <class Work>
auto ArchiveDialog::whileOpen(Work work) {
  return [dialog = QPointer<ArchiveDialog>(this), work = std::move(work)](auto&&... answer) {
    if (dialog)
      work(std::forward<decltype(answer)>(answer)...);
  };
}

ArchiveDialog::ArchiveDialog(ArchiveClient& client, const QString& chosen, QWidget* parent)
    : QDialog(parent), client_(client), archives_(new QComboBox),
      patientName_(
          makeField(tr("The beginning of the name; * stands for any letters"), "archivePatientName")),
      patientId_(makeField(tr("The beginning of the number of the patient"), "archivePatientId")),
      from_(makeField(tr("The first day of the study, as 2024-03-01"), "archiveFrom")),
      to_(makeField(tr("The last day of the study, as 2024-03-31"), "archiveTo")), modality_(new QComboBox),
      list_(new QTreeWidget), said_(new WrappedLabel), progress_(new QProgressBar) {
  setObjectName(QStringLiteral("archive"));
  setWindowTitle(tr("From the archive"));
  resize(880, 540); // Of 1920 x 1200 pixels at 200 % a dialog has 960 x 600 less its frame.
  said_->setObjectName(QStringLiteral("archiveSaid"));
  makeList();
  auto* buttons = new QDialogButtonBox;
  open_ = makeDialogButton(tr("Open"), tr("Fetch what is chosen and open it"), "archiveOpen");
  buttons->addButton(open_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(open_, &QPushButton::clicked, this, &ArchiveDialog::openChosen);
  auto* column = makeLayout<QVBoxLayout>(this, 12, {16, 16, 16, 16});
  column->addLayout(makeArchives());
  column->addLayout(makeQuery());
  column->addWidget(list_, 1);
  column->addWidget(said_);
  column->addLayout(makeProgress());
  column->addWidget(buttons);
  connect(&client_, &ArchiveClient::progressed, this, &ArchiveDialog::syncProgress);
  connect(&client_, &ArchiveClient::failed, this, [this](const QString& sentence) { say(sentence); });
  connect(this, &QDialog::finished, &client_, &ArchiveClient::cancel);
  fillArchives(chosen);
  syncProgress();
}

QLayout* ArchiveDialog::makeArchives() {
  archives_->setObjectName(QStringLiteral("archiveList"));
  archives_->setAccessibleName(tr("Archive"));
  archives_->setToolTip(tr("The archive to search"));
  auto* add = makeDialogButton(tr("Add..."), tr("Name another archive"), "archiveAdd");
  edit_ =
      makeDialogButton(tr("Edit..."), tr("Change the address and the titles of this archive"), "archiveEdit");
  remove_ = makeDialogButton(tr("Remove"), tr("Forget this archive and its password"), "archiveRemove");
  test_ = makeDialogButton(tr("Test"), tr("Ask whether the archive answers"), "archiveTest");
  connect(add, &QPushButton::clicked, this, [this] { edit(true); });
  connect(edit_, &QPushButton::clicked, this, [this] { edit(false); });
  connect(remove_, &QPushButton::clicked, this, &ArchiveDialog::remove);
  connect(test_, &QPushButton::clicked, this, &ArchiveDialog::test);
  connect(archives_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    list_->clear();
    sync();
    Q_EMIT archiveChosen(archives_->currentText());
  });
  auto* row = makeLayout<QHBoxLayout>(nullptr);
  row->addWidget(archives_, 1);
  for (QPushButton* button : {add, edit_, remove_, test_})
    row->addWidget(button);
  return row;
}

QLayout* ArchiveDialog::makeQuery() {
  modality_->addItem(tr("Any"), QString());
  for (const char* modality : kModalities)
    modality_->addItem(QLatin1String(modality), QLatin1String(modality));
  modality_->setToolTip(tr("Only studies with images of this kind"));
  search_ = makeDialogButton(tr("Search"), tr("List the studies that match (Return)"), "archiveSearch");
  search_->setDefault(true);
  connect(search_, &QPushButton::clicked, this, &ArchiveDialog::search);
  auto* grid = makeLayout<QGridLayout>(nullptr);
  const std::pair<QString, QWidget*> fields[] = {{tr("Patient's name"), patientName_},
                                                 {tr("Patient's number"), patientId_},
                                                 {tr("From"), from_},
                                                 {tr("To"), to_},
                                                 {tr("Modality"), modality_}};
  int at = 0;
  for (const auto& [title, field] : fields) {
    auto* label = new QLabel(title);
    label->setBuddy(field);
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(label, 0, at);
    grid->addWidget(field, 1, at);
    grid->setColumnStretch(at, at < 2 ? 3 : 2);
    ++at;
  }
  from_->setPlaceholderText(tr("YYYY-MM-DD"));
  to_->setPlaceholderText(tr("YYYY-MM-DD"));
  for (QLineEdit* field : {patientName_, patientId_, from_, to_})
    connect(field, &QLineEdit::returnPressed, this, &ArchiveDialog::search);
  grid->addWidget(search_, 1, at);
  return grid;
}

void ArchiveDialog::makeList() {
  list_->setObjectName(QStringLiteral("archiveStudies"));
  list_->setAccessibleName(tr("Studies and series"));
  list_->setColumnCount(kColumns);
  list_->setHeaderLabels(
      {tr("Patient"), tr("Number"), tr("Date"), tr("Modality"), tr("Description"), tr("Images")});
  list_->setUniformRowHeights(true);
  list_->setAlternatingRowColors(true);
  list_->header()->setStretchLastSection(false);
  for (int column = 0; column < kColumns; ++column)
    list_->header()->setSectionResizeMode(column, column == kDescription ? QHeaderView::Stretch
                                                                         : QHeaderView::ResizeToContents);
  connect(list_, &QTreeWidget::itemExpanded, this, &ArchiveDialog::fetchSeries);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &ArchiveDialog::sync);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, [this](const QTreeWidgetItem* item) {
    if (item->parent())
      openChosen();
  });
}

QLayout* ArchiveDialog::makeProgress() {
  progress_->setObjectName(QStringLiteral("archiveProgress"));
  progress_->setRange(0, int(kPerMille));
  cancel_ = makeDialogButton(tr("Cancel"), tr("Stop; nothing incomplete is kept"), "archiveCancel");
  connect(cancel_, &QPushButton::clicked, this, [this] {
    client_.cancel();
    say(tr("Cancelled. Nothing was kept."));
  });
  auto* row = makeLayout<QHBoxLayout>(nullptr);
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  return row;
}

void ArchiveDialog::say(const QString& sentence) {
  said_->setText(sentence);
}

void ArchiveDialog::fillArchives(const QString& chosen) {
  try {
    connections_ = client_.connections();
  } catch (const Error& error) {
    connections_.clear();
    say(sentenceOf(error));
  }
  const QSignalBlocker quiet(archives_);
  archives_->clear();
  for (const clinic::ArchiveConnection& each : connections_)
    archives_->addItem(text(each.name));
  archives_->setCurrentIndex(std::max(0, archives_->findText(chosen)));
  list_->clear();
  if (connections_.empty() && said_->text().isEmpty())
    say(tr("No archive is named yet. Add one: its address, and for the classic services its title."));
  sync();
}

const clinic::ArchiveConnection* ArchiveDialog::present() const {
  const int index = archives_->currentIndex();
  return index >= 0 && std::size_t(index) < connections_.size() ? &connections_[std::size_t(index)] : nullptr;
}

void ArchiveDialog::edit(bool added) {
  const clinic::ArchiveConnection* before = present();
  if (!added && !before)
    return;
  QStringList taken;
  for (const clinic::ArchiveConnection& each : connections_)
    if (added || each.name != before->name)
      taken << text(each.name);
  ConnectionDialog dialog(added ? clinic::ArchiveConnection() : *before, taken, this);
  if (dialog.exec() != Accepted)
    return;
  std::vector<clinic::ArchiveConnection> all = connections_;
  if (added)
    all.push_back(dialog.connection());
  else
    all[std::size_t(archives_->currentIndex())] = dialog.connection();
  write(all, text(dialog.connection().name));
}

void ArchiveDialog::remove() {
  const clinic::ArchiveConnection* removed = present();
  if (!removed ||
      QMessageBox::question(this, tr("Remove the archive?"),
                            tr("Forget %1 and its password?").arg(text(removed->name))) != QMessageBox::Yes)
    return;
  client_.forgetPassword(*removed);
  std::vector<clinic::ArchiveConnection> all = connections_;
  all.erase(all.begin() + archives_->currentIndex());
  write(all, {});
}

bool ArchiveDialog::write(const std::vector<clinic::ArchiveConnection>& connections, const QString& chosen) {
  say({});
  try {
    client_.setConnections(connections);
  } catch (const Error& error) {
    say(sentenceOf(error));
    return false;
  }
  fillArchives(chosen);
  Q_EMIT archiveChosen(archives_->currentText());
  return true;
}

void ArchiveDialog::test() {
  if (const clinic::ArchiveConnection* tested = present()) {
    say({});
    client_.test(*tested, whileOpen([this, name = text(tested->name)] { say(tr("%1 answers.").arg(name)); }));
  }
}

void ArchiveDialog::search() {
  const clinic::ArchiveConnection* searched = present();
  if (!searched)
    return;
  clinic::ArchiveQuery query;
  for (const auto& [field, day] : {std::pair{from_, &query.from}, std::pair{to_, &query.to}}) {
    const auto typed = asDay(field->text());
    if (!typed) {
      field->setFocus();
      return say(tr("%1 is no day. Write it as 2024-03-01.").arg(field->text()));
    }
    *day = *typed;
  }
  query.patientName = asPattern(patientName_->text());
  query.patientId = asPattern(patientId_->text());
  query.modality = modality_->currentData().toString().toStdString();
  list_->clear();
  sync();
  say({});
  client_.query(*searched, query, whileOpen([this](const std::vector<clinic::ArchiveStudy>& studies) {
    showStudies(studies);
  }));
}

void ArchiveDialog::showStudies(const std::vector<clinic::ArchiveStudy>& studies) {
  list_->clear();
  for (const clinic::ArchiveStudy& study : studies) {
    auto* item =
        new QTreeWidgetItem(list_, {patientShown(study.patientName), text(study.patientId),
                                    shownDay(study.date), text(study.modalities), text(study.description)});
    item->setData(0, kStudyUid, text(study.studyUid));
    item->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
  }
  say(studies.empty() ? tr("No study matches.")
                      : tr("%n studies. Open one to see its series.", nullptr, int(studies.size())));
  if (studies.size() == 1)
    list_->topLevelItem(0)->setExpanded(true);
}

void ArchiveDialog::fetchSeries(QTreeWidgetItem* item) {
  const clinic::ArchiveConnection* searched = present();
  if (!searched || item->parent() || item->childCount() > 0)
    return;
  clinic::ArchiveQuery query;
  query.studyUid = item->data(0, kStudyUid).toString().toStdString();
  client_.query(*searched, query,
                whileOpen([this, uid = query.studyUid](const std::vector<clinic::ArchiveStudy>& studies) {
                  showSeries(uid, studies);
                }));
}

void ArchiveDialog::showSeries(const std::string& studyUid,
                               const std::vector<clinic::ArchiveStudy>& studies) {
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* item = list_->topLevelItem(row);
    if (item->data(0, kStudyUid).toString().toStdString() != studyUid || item->childCount() > 0)
      continue;
    for (const clinic::ArchiveStudy& study : studies)
      for (const clinic::ArchiveSeries& series : study.series) {
        auto* child = new QTreeWidgetItem(
            item, {tr("Series %1").arg(text(series.number)), QString(), QString(), text(series.modality),
                   text(series.description), series.images < 0 ? QString() : QString::number(series.images)});
        child->setData(0, kStudyUid, text(studyUid));
        child->setData(0, kSeriesUid, text(series.seriesUid));
        child->setData(0, kImageCount, series.images);
      }
    if (item->childCount() > 0)
      list_->setCurrentItem(item->child(0));
    else
      say(tr("This study has no series."));
  }
}

void ArchiveDialog::openChosen() {
  const QTreeWidgetItem* item = list_->currentItem();
  const clinic::ArchiveConnection* searched = present();
  if (!item || !searched || item->data(0, kStudyUid).toString().isEmpty())
    return;
  say({});
  const QVariant images = item->data(0, kImageCount);
  Q_EMIT openWanted({*searched, item->data(0, kStudyUid).toString().toStdString(),
                     item->data(0, kSeriesUid).toString().toStdString(),
                     images.isValid() ? images.toInt() : -1});
}

void ArchiveDialog::sync() {
  const bool any = present() != nullptr;
  for (QPushButton* button : {edit_, remove_, test_, search_})
    button->setEnabled(any);
  const QTreeWidgetItem* item = list_->currentItem();
  open_->setEnabled(any && item != nullptr);
  open_->setText(item && !item->parent() ? tr("Open the study") : tr("Open"));
}

void ArchiveDialog::syncProgress() {
  const std::optional<JobInfo> job = client_.present();
  progress_->setEnabled(job.has_value());
  cancel_->setEnabled(job.has_value());
  progress_->setValue(job ? int(job->fraction * kPerMille) : 0);
  progress_->setFormat(job ? inWords(job->step.empty() ? job->name : job->step) : QString());
}

} // namespace viscera::app
