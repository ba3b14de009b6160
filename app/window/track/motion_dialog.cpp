#include "window/track/motion_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>

#include "viscera/anatomy/part.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/track/cine_page.h"
#include "window/widgets/page.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {
namespace {

constexpr const char* kLookSlot = "lookIntoSeries";
constexpr int kItemName = 0, kItemPart = 1, kItemColumns = 2;
constexpr int kItemHeight = 32, kShownItems = 6;
constexpr double kSecondsPerMinute = 60;
constexpr double kLongestMs = 60'000, kPeriodStep = 10;
constexpr int kFewestTrackedHandles = 12, kMostTrackedHandles = 1000;
constexpr double kMostRobustMm = 20;
constexpr int kDialogWidth = 500;

QString partName(live::SeriesPart part, bool labels) {
  switch (part) {
  case live::SeriesPart::cavity:
    return MotionDialog::tr("Cavity");
  case live::SeriesPart::tissue:
    return labels ? MotionDialog::tr("Tissue around cavities") : MotionDialog::tr("Use");
  default:
    return MotionDialog::tr("Leave out");
  }
}

/// Whether the seconds in a box of so many decimals of a ms are what the files say.
bool isPeriod(const std::optional<double>& stated, double seconds, int decimals) {
  return stated && std::abs(*stated - seconds) <= 0.5 * std::pow(10, -decimals) / kMsPerSecond;
}

} // namespace

MotionDialog::MotionDialog(Workspace& workspace, MeasuredMotion& measured, Settings& settings,
                           QWidget* parent)
    : QDialog(parent), workspace_(workspace), measured_(measured), settings_(settings) {
  setObjectName(QStringLiteral("motionDialog"));
  setWindowTitle(tr("Motion from a series"));
  setFixedWidth(kDialogWidth);
  auto* column = new QVBoxLayout(this);
  setAcceptDrops(true);
  makeSource(*column);
  makeFiles(*column);
  makeItems(*column);
  makeTimes(*column);
  column->addWidget(new CollapsibleSection(tr("More"), makeMore(), false, this));
  said_ = new WrappedLabel(this);
  said_->setObjectName(QStringLiteral("motionSaid"));
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(said_);
  missing_ = makeRemark({}, this);
  missing_->setObjectName(QStringLiteral("motionMissing"));
  column->addWidget(missing_);
  makeButtons(*column);
  connect(&measured, &MeasuredMotion::ended, this, &MotionDialog::onEnded);
  setFromImages(false);
}

void MotionDialog::makeButtons(QVBoxLayout& column) {
  auto* buttons = makeLayout<QHBoxLayout>(nullptr, 8);
  buttons->addStretch(1);
  cancel_ = new QPushButton(tr("Cancel the search"), this);
  cancel_->setObjectName(QStringLiteral("motionCancel"));
  connect(cancel_, &QPushButton::clicked, &measured_, &MeasuredMotion::cancel);
  buttons->addWidget(cancel_);
  auto* close = new QPushButton(tr("Close"), this);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  buttons->addWidget(close);
  start_ = new QPushButton(tr("Find the motion"), this);
  start_->setObjectName(QStringLiteral("primary"));
  connect(start_, &QPushButton::clicked, this, &MotionDialog::start);
  buttons->addWidget(start_);
  column.addLayout(buttons);
}

void MotionDialog::makeSource(QVBoxLayout& column) {
  source_ = new QComboBox(this);
  source_->setObjectName(QStringLiteral("motionSource"));
  source_->setAccessibleName(tr("What the motion is found from"));
  source_->addItem(tr("Labels or surfaces of every phase"));
  source_->addItem(tr("Cine images, and labels of a few phases"));
  connect(source_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int index) { setFromImages(index == 1); });
  column.addWidget(source_);
}

bool MotionDialog::fromImages() const {
  return source_->currentIndex() == 1;
}

void MotionDialog::setFromImages(bool images) {
  const QSignalBlocker quiet(source_);
  source_->setCurrentIndex(images ? 1 : 0);
  seriesBox_->setVisible(!images);
  cine_->setVisible(images);
  about_->setText(
      images
          ? tr("Turns the labels of a few phases, the ends of diastole and systole at least, and cine images "
               "of the whole cycle into handles and a key sequence with a key for each phase. Volumes of "
               "labelled phases are exact; the images show the others. One labelled phase gives an estimate. "
               "The result replaces the open organs; Undo brings them back.")
          : tr("Turns one organ, given in several phases of a cycle, into handles and a key sequence with a "
               "key for each phase. Choose surfaces or label maps, one file for each phase, or one file with "
               "several phases. The result replaces the open organs; Undo brings them back."));
  for (QWidget* part :
       {static_cast<QWidget*>(robust_), static_cast<QWidget*>(robustName_), static_cast<QWidget*>(loop_)})
    part->setVisible(!images); // Images show a whole cycle, and have their own limit.
  leaveOutName_->setText(images ? tr("Leave out series") : tr("Leave out phases"));
  contents_ = {};
  files_.clear();
  forgetLook();
  say({}, false);
  fillItems();
  sync();
  if (images)
    lookAtCineLabels();
}

void MotionDialog::forgetLook() {
  ++looks_;
  looking_ = false;
}

void MotionDialog::offerStudy() {
  if (!workspace_.state().study || !files_.isEmpty() || cine_->draft().cycle() || finding_)
    return;
  setFromImages(true);
  cine_->useStudy(workspace_.state().study);
}

void MotionDialog::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls())
    event->acceptProposedAction();
}

void MotionDialog::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile())
      files.push_back(url.toLocalFile());
  if (files.isEmpty())
    return;
  event->acceptProposedAction();
  if (fromImages())
    cine_->takeDropped(files);
  else
    look(files);
}

/// Keeps the dialog as high as what is in it: sentences wrap, and parts come and go.
bool MotionDialog::event(QEvent* event) {
  const bool handled = QDialog::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show)
    resize(width(), layout()->totalHeightForWidth(width()));
  return handled;
}

void MotionDialog::makeFiles(QVBoxLayout& column) {
  about_ = makeRemark({}, this);
  column.addWidget(about_);
  seriesBox_ = new QWidget(this);
  auto* box = makeLayout<QVBoxLayout>(seriesBox_, 8);
  auto* row = makeLayout<QHBoxLayout>(nullptr, 8);
  auto* folder = new QPushButton(icon("open"), tr("Folder..."), this);
  folder->setObjectName(QStringLiteral("seriesFolder"));
  connect(folder, &QPushButton::clicked, this, &MotionDialog::chooseFolder);
  row->addWidget(folder);
  auto* files = new QPushButton(icon("open"), tr("Files..."), this);
  files->setObjectName(QStringLiteral("seriesFiles"));
  files->setToolTip(tr("All phases, or one 4D NIfTI or .seq.nrrd"));
  connect(files, &QPushButton::clicked, this, &MotionDialog::chooseFiles);
  row->addWidget(files);
  row->addStretch(1);
  box->addLayout(row);
  what_ = new WrappedLabel(this);
  what_->setObjectName(QStringLiteral("seriesWhat"));
  box->addWidget(what_);
  column.addWidget(seriesBox_);
  cine_ = new CinePage(workspace_, settings_, this);
  connect(cine_, &CinePage::changed, this, &MotionDialog::takeImages);
  connect(cine_, &CinePage::labelsChanged, this, &MotionDialog::lookAtCineLabels);
  connect(cine_, &CinePage::refused, this, [this](const QString& why) { say(why, true); });
  column.addWidget(cine_);
}

/// The images say how long a cycle lasts; a user may say otherwise.
void MotionDialog::takeImages() {
  const auto& cycle = cine_->draft().cycle();
  if (cycle && cycle->periodSeconds && cyclePlace_ != cycle->place)
    period_->setValue(kMsPerSecond * *cycle->periodSeconds);
  cyclePlace_ = cycle ? cycle->place : std::filesystem::path();
  sync();
}

/// Which surfaces there are is read from the first labelled phase.
void MotionDialog::lookAtCineLabels() {
  if (!fromImages())
    return;
  contents_ = {};
  forgetLook();
  fillItems();
  if (const auto labels = cine_->firstLabels())
    lookIntoLabels([labels](Progress& progress) { return live::lookIntoPhase(*labels, progress); });
  sync();
}

void MotionDialog::makeItems(QVBoxLayout& column) {
  items_ = new QTableWidget(0, kItemColumns, this);
  items_->setObjectName(QStringLiteral("seriesItems"));
  items_->setAccessibleName(tr("Surfaces of the series"));
  items_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  items_->horizontalHeader()->setHighlightSections(false);
  items_->verticalHeader()->hide();
  items_->verticalHeader()->setDefaultSectionSize(kItemHeight);
  items_->setShowGrid(false);
  items_->setSelectionMode(QAbstractItemView::NoSelection);
  connect(items_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (item->column() == kItemName && contents_.labels && !item->text().trimmed().isEmpty())
      contents_.items[static_cast<std::size_t>(item->row())].name = item->text().trimmed().toStdString();
  });
  column.addWidget(items_);
}

void MotionDialog::makeTimes(QVBoxLayout& column) {
  auto* form = new QFormLayout;
  auto* row = makeLayout<QHBoxLayout>(nullptr, 8);
  period_ = new QDoubleSpinBox(this);
  period_->setObjectName(QStringLiteral("seriesPeriod"));
  period_->setRange(0, kLongestMs);
  period_->setSingleStep(kPeriodStep);
  period_->setDecimals(1);
  period_->setSuffix(tr(" ms"));
  period_->setToolTip(tr("Duration of one whole cycle: the number of phases times the step between them"));
  connect(period_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &MotionDialog::sync);
  row->addWidget(period_);
  rate_ = new QLabel(this);
  rate_->setObjectName(QStringLiteral("muted"));
  row->addWidget(rate_, 1);
  form->addRow(tr("Duration of one cycle"), row);
  loop_ = new QCheckBox(tr("The last phase leads back to the first"), this);
  loop_->setObjectName(QStringLiteral("seriesLoop"));
  loop_->setChecked(true);
  form->addRow(QString(), loop_);
  column.addLayout(form);
}

QWidget* MotionDialog::makeMore() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  handles_ = new QSpinBox(box);
  handles_->setObjectName(QStringLiteral("seriesHandles"));
  handles_->setRange(kFewestTrackedHandles - 1, kMostTrackedHandles);
  handles_->setSpecialValueText(tr("Automatic"));
  handles_->setToolTip(tr("60 for one surface, 120 for several. More follow the surfaces more closely"));
  form->addRow(tr("Handles"), handles_);
  keepVolumes_ = new QCheckBox(tr("Keep the measured volumes exactly"), box);
  keepVolumes_->setChecked(true);
  form->addRow(QString(), keepVolumes_);
  robust_ = new QDoubleSpinBox(box);
  robust_->setRange(0, kMostRobustMm);
  robust_->setDecimals(1);
  robust_->setSuffix(tr(" mm"));
  robust_->setSpecialValueText(tr("No limit"));
  robust_->setToolTip(tr("Larger distances count less: for label maps with outliers"));
  robustName_ = new QLabel(tr("Distances count less beyond"), box);
  form->addRow(robustName_, robust_);
  leaveOut_ = new QLineEdit(box);
  leaveOut_->setObjectName(QStringLiteral("seriesLeaveOut"));
  leaveOut_->setPlaceholderText(tr("For example 3, 7"));
  leaveOutName_ = new QLabel(tr("Leave out phases"), box);
  form->addRow(leaveOutName_, leaveOut_);
  return box;
}

void MotionDialog::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(
      this, tr("Folder with a series"), settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation));
  if (!folder.isEmpty())
    look({folder});
}

void MotionDialog::chooseFiles() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Phases of a series"), settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation));
  if (!files.isEmpty())
    look(files);
}

void MotionDialog::look(const QStringList& files) {
  if (fromImages())
    setFromImages(false);
  files_ = files;
  contents_ = {};
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files)
    paths.emplace_back(file.toStdString());
  settings_.setValue(kFolderKey, QFileInfo(files.front()).absolutePath());
  fillItems();
  say({}, false);
  lookIntoLabels([paths](Progress& progress) { return live::lookIntoSeries(paths, progress); });
  sync();
}

void MotionDialog::lookIntoLabels(std::function<live::SeriesContents(Progress&)> read) {
  looking_ = true;
  workspace_.jobs().submit<live::SeriesContents>(
      tr("Reading the series").toStdString(), kLookSlot, std::move(read),
      [this, self = QPointer<MotionDialog>(this), number = ++looks_](JobResult<live::SeriesContents> result) {
        if (!self || number != looks_)
          return; // Others took their place.
        looking_ = false;
        if (result.error) {
          files_.clear();
          say(sentenceOf(*result.error), true);
        }
        if (result.value)
          take(*result.value);
        sync();
      });
}

void MotionDialog::take(const live::SeriesContents& contents) {
  contents_ = contents;
  if (fromImages())
    return fillItems();
  if (contents.periodSeconds)
    period_->setValue(kMsPerSecond * *contents.periodSeconds);
  say(contents.phases == 1
          ? tr("A single image shows no motion. Open it with File > Open, then choose \"Fit a sequence to an "
               "organ\" in Play mode to give the heart and its chambers the textbook's beat.")
          : inWords(contents.doubt),
      false);
  fillItems();
}

void MotionDialog::fillItems() {
  const QSignalBlocker quiet(items_);
  items_->setVisible(!contents_.items.empty());
  items_->setHorizontalHeaderLabels({contents_.labels ? tr("Label") : tr("Surface"), tr("Role")});
  items_->setRowCount(static_cast<int>(contents_.items.size()));
  for (int row = 0; row < items_->rowCount(); ++row) {
    live::SeriesItem& item = contents_.items[static_cast<std::size_t>(row)];
    auto* name = new QTableWidgetItem(text(item.name));
    name->setFlags(contents_.labels ? Qt::ItemIsEnabled | Qt::ItemIsEditable : Qt::ItemIsEnabled);
    name->setToolTip(contents_.labels
                         ? tr("Label %1; a double click gives the surface another name").arg(text(item.label))
                         : text(item.name));
    items_->setItem(row, kItemName, name);
    auto* part = new QComboBox(items_);
    if (contents_.labels)
      part->addItem(partName(live::SeriesPart::cavity, true), int(live::SeriesPart::cavity));
    part->addItem(partName(live::SeriesPart::tissue, contents_.labels), int(live::SeriesPart::tissue));
    part->addItem(partName(live::SeriesPart::unused, contents_.labels), int(live::SeriesPart::unused));
    part->setCurrentIndex(part->findData(int(item.part)));
    part->setAccessibleName(tr("Role of %1").arg(text(item.name)));
    connect(part, QOverload<int>::of(&QComboBox::activated), this, [this, row, part] {
      contents_.items[static_cast<std::size_t>(row)].part =
          static_cast<live::SeriesPart>(part->currentData().toInt());
    });
    items_->setCellWidget(row, kItemPart, part);
  }
  const int rows = std::min(items_->rowCount(), kShownItems);
  items_->setFixedHeight(items_->horizontalHeader()->sizeHint().height() + rows * kItemHeight + 4);
}

void MotionDialog::sync() {
  const double period = period_->value();
  rate_->setText(period > 0
                     ? tr("%1 a minute").arg(formatNumber(kSecondsPerMinute * kMsPerSecond / period, 0))
                     : tr("The files do not state it"));
  rate_->setVisible(period > 0 || !contents_.items.empty());
  QString what = tr("No series is chosen.");
  if (looking_ && !files_.isEmpty())
    what = tr("Reading %1 ...").arg(QFileInfo(files_.front()).fileName());
  else if (!contents_.items.empty() && !files_.isEmpty())
    what = (contents_.labels ? tr("%1: label maps, %n phases", nullptr, int(contents_.phases))
                             : tr("%1: surfaces, %n phases", nullptr, int(contents_.phases)))
               .arg(QFileInfo(files_.front()).fileName());
  what_->setText(what);
  const QString lacks = missing();
  start_->setEnabled(lacks.isEmpty() && !finding_);
  start_->setText(finding_ ? tr("Working...") : tr("Find the motion"));
  start_->setToolTip(lacks);
  missing_->setText(lacks);
  // Another label shows the reason where there is no series, or one image.
  missing_->setVisible(!lacks.isEmpty() &&
                       (fromImages() || (!contents_.items.empty() && contents_.phases != 1)));
  cancel_->setVisible(finding_);
}

/// The input that is missing before the search can start; empty when it is complete.
QString MotionDialog::missing() const {
  if (fromImages()) {
    if (const Text lacks = cine_->draft().missing(); !lacks.empty())
      return inWords(lacks);
    if (contents_.items.empty())
      return looking_ ? tr("The labels are being read") : tr("Choose other labels: these cannot be read");
    return period_->value() > 0 ? QString() : tr("Enter the duration of one cycle first");
  }
  if (contents_.items.empty())
    return tr("Choose a series first");
  if (contents_.phases == 1)
    return tr("A single image shows no motion");
  return period_->value() > 0 ? QString() : tr("Enter the duration of one cycle first");
}

live::SeriesRequest MotionDialog::request() const {
  live::SeriesRequest request;
  for (const QString& file : files_)
    request.inputs.emplace_back(file.toStdString());
  request.surfaces = surfaces();
  // The files' own times are kept as long as the period is theirs.
  const double seconds = period_->value() / kMsPerSecond;
  if (!isPeriod(contents_.periodSeconds, seconds, period_->decimals()))
    request.periodSeconds = seconds;
  request.leftOut = leftOut();
  for (std::size_t& phase : request.leftOut)
    --phase;
  request.loop = loop_->isChecked();
  return request;
}

live::CineRequest MotionDialog::cineRequest() const {
  live::CineRequest request = cine_->draft().request();
  // One surface in a file a phase has the name that its files share.
  if (contents_.labels || contents_.items.size() > 1)
    request.surfaces = surfaces();
  const double seconds = period_->value() / kMsPerSecond;
  if (!isPeriod(cine_->draft().cycle()->periodSeconds, seconds, period_->decimals()))
    request.periodSeconds = seconds;
  for (const std::size_t series : leftOut())
    request.leftOutSeries.push_back(static_cast<int>(series));
  return request;
}

std::vector<live::LabelledSurface> MotionDialog::surfaces() const {
  const bool heart = std::any_of(contents_.items.begin(), contents_.items.end(), [](const auto& item) {
    return item.part == live::SeriesPart::cavity && anatomy::chamberNamed(item.name);
  });
  return live::chosenSurfaces(contents_, (heart ? tr("Heart") : tr("Outer surface")).toStdString());
}

/// Numbers of phases or of series, as typed.
std::vector<std::size_t> MotionDialog::leftOut() const {
  std::vector<std::size_t> numbers;
  for (const QString& number :
       leaveOut_->text().split(QRegularExpression(QStringLiteral("[,;\\s]+")), Qt::SkipEmptyParts)) {
    bool isNumber = false;
    const int phase = number.toInt(&isNumber);
    if (!isNumber || phase < 1)
      throw fromImages()
          ? UsageError(tr("%1 is not the number of a series").arg(number).toStdString(), {},
                       tr("name series by their numbers, as in 3, 7").toStdString())
          : UsageError(tr("%1 is not a phase").arg(number).toStdString(), {},
                       tr("name phases by their numbers, counted from 1, as in 3, 7").toStdString());
    numbers.push_back(static_cast<std::size_t>(phase));
  }
  return numbers;
}

live::TrackOptions MotionDialog::options() const {
  live::TrackOptions options;
  options.rig.handles = handles_->value() < kFewestTrackedHandles ? 0 : handles_->value();
  options.keepVolumes = keepVolumes_->isChecked();
  options.robustMm = robust_->value();
  return options;
}

void MotionDialog::start() {
  if (!start_->isEnabled())
    return;
  try {
    const auto search = fromImages() ? std::function<void()>([this, asked = cineRequest()] {
      measured_.findFromImages(asked, options(), cine_->study());
    })
                                     : [this, asked = request()] { measured_.find(asked, options()); };
    finding_ = true;
    say({}, false);
    sync();
    search();
  } catch (const Error& error) {
    say(sentenceOf(error), true);
  }
}

void MotionDialog::onEnded(const QString& refusal) {
  finding_ = false;
  sync();
  if (refusal.isEmpty())
    close();
  else if (isVisible())
    say(refusal, true);
  else
    workspace_.say({Message::Severity::error, refusal, {}, 0});
}

QString MotionDialog::said() const {
  return said_->text();
}

void MotionDialog::say(const QString& what, bool refused) {
  said_->setText(what);
  said_->setVisible(!what.isEmpty());
  said_->setProperty("refused", refused);
  said_->style()->unpolish(said_);
  said_->style()->polish(said_);
}

} // namespace viscera::app
