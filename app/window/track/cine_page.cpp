#include "window/track/cine_page.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {
namespace {

constexpr const char* kImagesSlot = "lookIntoImages";
enum LabelColumn { kLabelFile, kLabelPhase, kLabelRemove, kLabelColumns };
constexpr int kLabelRowHeight = 32, kShownLabels = 4, kPhaseWidth = 150, kRemoveWidth = 36;

} // namespace

CinePage::CinePage(Workspace& workspace, Settings& settings, QWidget* parent)
    : QWidget(parent), workspace_(workspace), settings_(settings) {
  auto* column = makeLayout<QVBoxLayout>(this, 8);
  makeImages(*column);
  makeLabels(*column);
  remark_ = new WrappedLabel(this);
  remark_->setObjectName(QStringLiteral("cineRemark"));
  remark_->setProperty("doubtful", true);
  column->addWidget(remark_);
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.study())
      sync();
  });
  fill();
  sync();
}

void CinePage::makeImages(QVBoxLayout& column) {
  auto* row = makeLayout<QHBoxLayout>(nullptr, 8);
  openStudy_ = new QPushButton(tr("Open study"), this);
  openStudy_->setObjectName(QStringLiteral("cineOpenStudy"));
  openStudy_->setToolTip(tr("Take the images that are open in the window"));
  connect(openStudy_, &QPushButton::clicked, this, [this] { useStudy(workspace_.state().study); });
  row->addWidget(openStudy_);
  auto* folder = new QPushButton(icon("open"), tr("Images..."), this);
  folder->setObjectName(QStringLiteral("cineFolder"));
  folder->setToolTip(tr("A folder with the DICOM files of a cine study"));
  connect(folder, &QPushButton::clicked, this, [this] { chooseImages(true); });
  row->addWidget(folder);
  auto* file = new QPushButton(icon("open"), tr("Image file..."), this);
  file->setObjectName(QStringLiteral("cineFile"));
  file->setToolTip(tr("One file of images over time: 4D NIfTI or .seq.nrrd"));
  connect(file, &QPushButton::clicked, this, [this] { chooseImages(false); });
  row->addWidget(file);
  row->addStretch(1);
  column.addLayout(row);
  images_ = new WrappedLabel(this);
  images_->setObjectName(QStringLiteral("cineImages"));
  column.addWidget(images_);
}

void CinePage::makeLabels(QVBoxLayout& column) {
  auto* row = makeLayout<QHBoxLayout>(nullptr, 8);
  auto* files = new QPushButton(icon("open"), tr("Labels..."), this);
  files->setObjectName(QStringLiteral("cineLabelFiles"));
  files->setToolTip(tr("Label maps or surfaces of single phases: the ends of diastole and systole at least"));
  connect(files, &QPushButton::clicked, this, [this] { chooseLabels(false); });
  row->addWidget(files);
  auto* folder = new QPushButton(icon("open"), tr("Folder of one phase..."), this);
  folder->setObjectName(QStringLiteral("cineLabelFolder"));
  folder->setToolTip(tr("A folder with all surfaces of one phase"));
  connect(folder, &QPushButton::clicked, this, [this] { chooseLabels(true); });
  row->addWidget(folder);
  row->addStretch(1);
  column.addLayout(row);
  labels_ = new QTableWidget(0, kLabelColumns, this);
  labels_->setObjectName(QStringLiteral("cineLabels"));
  labels_->setAccessibleName(tr("Labels and their phases"));
  labels_->setHorizontalHeaderLabels({tr("Labels"), tr("Phase"), QString()});
  labels_->horizontalHeader()->setSectionResizeMode(kLabelFile, QHeaderView::Stretch);
  for (const auto& [section, width] :
       {std::pair(int(kLabelPhase), kPhaseWidth), std::pair(int(kLabelRemove), kRemoveWidth)}) {
    labels_->horizontalHeader()->setSectionResizeMode(section, QHeaderView::Fixed);
    labels_->setColumnWidth(section, width);
  }
  labels_->horizontalHeader()->setHighlightSections(false);
  labels_->verticalHeader()->hide();
  labels_->verticalHeader()->setDefaultSectionSize(kLabelRowHeight);
  labels_->setShowGrid(false);
  labels_->setSelectionMode(QAbstractItemView::NoSelection);
  labels_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  labels_->setTextElideMode(Qt::ElideMiddle);
  column.addWidget(labels_);
}

void CinePage::look(const QString& name, std::function<Looked(Progress&)> work) {
  looking_ = name;
  study_.reset();
  draft_.setCycle(std::nullopt);
  fill();
  sync();
  workspace_.jobs().submit<Looked>(tr("Looking through the images").toStdString(), kImagesSlot,
                                   std::move(work),
                                   [this, self = QPointer<CinePage>(this), name](JobResult<Looked> result) {
                                     if (!self || looking_ != name)
                                       return;
                                     looking_.clear();
                                     if (result.error)
                                       Q_EMIT refused(sentenceOf(*result.error));
                                     if (result.value) {
                                       study_ = result.value->study;
                                       draft_.setCycle(result.value->cycle);
                                     }
                                     fill();
                                     sync();
                                     Q_EMIT changed();
                                   });
  Q_EMIT changed();
}

void CinePage::useStudy(std::shared_ptr<const document::StudyItem> study) {
  if (!study)
    return;
  look(text(study->name), [study](Progress& progress) {
    return Looked{study, live::cycleOf(*study->study, study->place, progress)};
  });
}

void CinePage::openImages(const QString& place) {
  settings_.setValue(kFolderKey, QFileInfo(place).absolutePath());
  look(QFileInfo(place).fileName(), [path = place.toStdString()](Progress& progress) {
    Looked looked;
    runPart(progress, 0, 0.5, [&](Progress& part) {
      looked.study = std::make_shared<const document::StudyItem>(document::readStudy(path, part));
    });
    runPart(progress, 0.5, 1,
            [&](Progress& part) { looked.cycle = live::cycleOf(*looked.study->study, path, part); });
    return looked;
  });
}

void CinePage::addLabels(const QStringList& files) {
  if (files.isEmpty())
    return;
  settings_.setValue(kFolderKey, QFileInfo(files.front()).absolutePath());
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files)
    paths.emplace_back(file.toStdString());
  draft_.add(std::move(paths));
  fill();
  sync();
  Q_EMIT labelsChanged();
  Q_EMIT changed();
}

void CinePage::takeDropped(const QStringList& files) {
  if (!draft_.cycle() && looking_.isEmpty() && files.size() == 1 && QFileInfo(files.front()).isDir())
    openImages(files.front());
  else
    addLabels(files);
}

void CinePage::chooseImages(bool folder) {
  const QString start = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString place = folder
                            ? QFileDialog::getExistingDirectory(this, tr("Folder with a cine study"), start)
                            : QFileDialog::getOpenFileName(this, tr("Images over time"), start);
  if (!place.isEmpty())
    openImages(place);
}

void CinePage::chooseLabels(bool folder) {
  const QString start = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  if (!folder)
    return addLabels(QFileDialog::getOpenFileNames(this, tr("Labels of single phases"), start));
  const QString place = QFileDialog::getExistingDirectory(this, tr("Surfaces of one phase"), start);
  if (!place.isEmpty())
    addLabels({place});
}

/// Any file serves where no phase is known.
std::optional<live::PhaseLabels> CinePage::firstLabels() const {
  const auto phases = draft_.labelled();
  live::PhaseLabels first{phases.empty() ? 0 : phases.front(), {}};
  for (const live::CineDraft::Labels& each : draft_.labels())
    if (phases.empty() ? first.files.empty() : each.phase == phases.front())
      first.files.push_back(each.file);
  return first.files.empty() ? std::nullopt : std::optional(first);
}

void CinePage::fill() {
  const auto& all = draft_.labels();
  const int phases = draft_.cycle() ? static_cast<int>(draft_.cycle()->phases) : 0;
  labels_->setVisible(!all.empty());
  labels_->setRowCount(0); // Its widgets are of other files.
  labels_->setRowCount(static_cast<int>(all.size()));
  for (int row = 0; row < labels_->rowCount(); ++row) {
    const live::CineDraft::Labels& each = all[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(each.file.filename().string());
    auto* item = new QTableWidgetItem(name);
    item->setToolTip(QString::fromStdString(each.file.string()));
    labels_->setItem(row, kLabelFile, item);
    auto* phase = new QSpinBox(labels_);
    phase->setRange(0, std::max(phases, each.phase ? static_cast<int>(*each.phase) + 1 : 0));
    phase->setSpecialValueText(tr("not said"));
    phase->setValue(each.phase ? static_cast<int>(*each.phase) + 1 : 0);
    phase->setSuffix(phases > 0 ? tr(" of %1").arg(phases) : QString());
    phase->setAccessibleName(tr("Phase of %1").arg(name));
    phase->setToolTip(each.guessed && each.phase ? tr("Guessed from the name and the images: check it")
                                                 : tr("The phase that these labels belong to"));
    phase->setEnabled(phases > 0);
    connect(phase, QOverload<int>::of(&QSpinBox::valueChanged), this, [this, row](int value) {
      draft_.setPhase(static_cast<std::size_t>(row),
                      value > 0 ? std::optional(static_cast<std::size_t>(value - 1)) : std::nullopt);
      sync();
      Q_EMIT changed();
    });
    labels_->setCellWidget(row, kLabelPhase, phase);
    auto* remove = makeIconButton("remove", tr("Leave out %1").arg(name), labels_);
    connect(
        remove, &QToolButton::clicked, this,
        [this, row] {
          draft_.remove(static_cast<std::size_t>(row));
          fill();
          sync();
          Q_EMIT labelsChanged();
          Q_EMIT changed();
        },
        Qt::QueuedConnection); // The button goes with its row.
    labels_->setCellWidget(row, kLabelRemove, remove);
  }
  const int rows = std::min(labels_->rowCount(), kShownLabels);
  labels_->setFixedHeight(labels_->horizontalHeader()->sizeHint().height() + rows * kLabelRowHeight + 4);
}

void CinePage::sync() {
  const auto open = workspace_.state().study;
  openStudy_->setVisible(open && !document::identical(open, study_));
  if (!looking_.isEmpty())
    images_->setText(tr("Reading %1 ...").arg(looking_));
  else if (!draft_.cycle())
    images_->setText(tr("No images are chosen."));
  else
    images_->setText(tr("%1: %2 phases, %n planes", nullptr, static_cast<int>(study_->study->slices.size()))
                         .arg(text(study_->name))
                         .arg(draft_.cycle()->phases));
  const Text remark = draft_.remark();
  remark_->setText(remark.empty() ? QString() : asSentence(remark));
  remark_->setVisible(!remark.empty());
}

} // namespace viscera::app
