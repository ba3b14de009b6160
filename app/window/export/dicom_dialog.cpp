#include "window/export/dicom_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "viscera/presentation/presenter.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr int kMostDicomInstants = 200;
constexpr int kIdentityHeight = 92, kOrgansHeight = 132; ///< Logical pixels: four lines, and six rows.

QCheckBox* makeKind(const QString& title, const QString& tip, const char* name, bool on) {
  auto* box = new QCheckBox(title);
  box->setToolTip(tip);
  box->setObjectName(QLatin1String(name));
  box->setChecked(on);
  return box;
}

} // namespace

DicomDialog::DicomDialog(const Offer& offer, QWidget* parent)
    : QDialog(parent), archives_(offer.archives),
      segmentation_(makeKind(tr("Segmentation (SEG)"),
                             tr("The organs as voxels on the grid of the scan, one file for each instant"),
                             "dicomSegmentation", true)),
      measurements_(makeKind(tr("Measurements (SR)"),
                             tr("A structured report of volumes, distances and angles for each instant"),
                             "dicomMeasurements", true)),
      surfaces_(makeKind(tr("Surfaces (STL)"), tr("The surface of each organ, one file for each"),
                         "dicomSurfaces", false)),
      contours_(makeKind(tr("Contours (RTSTRUCT)"),
                         tr("Contours on the slices of the scan, for radiotherapy"), "dicomContours", false)),
      organs_(new QListWidget), phases_(new QSpinBox),
      withoutIdentity_(
          makeKind(tr("Without identity"),
                   tr("No name, number or date of the patient, and new identifiers of study and series"),
                   "dicomWithoutIdentity", false)),
      identity_(new QPlainTextEdit), destination_(new QComboBox), folder_(new QLineEdit),
      said_(new WrappedLabel) {
  setObjectName(QStringLiteral("dicom"));
  setWindowTitle(tr("Export as DICOM"));
  resize(680, 540); // Of 1920 x 1200 pixels at 200 % a dialog has 960 x 600 less its frame.
  said_->setObjectName(QStringLiteral("dicomSaid"));
  phases_->setObjectName(QStringLiteral("dicomPhases"));
  phases_->setRange(0, kMostDicomInstants);
  phases_->setSpecialValueText(tr("The pose that is shown"));
  phases_->setEnabled(offer.moves);
  phases_->setToolTip(offer.moves ? tr("So many instants of one cycle of the motion")
                                  : tr("No motion moves the organs"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  export_ = buttons->button(QDialogButtonBox::Ok);
  export_->setObjectName(QStringLiteral("dicomExport"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* upper = makeLayout<QHBoxLayout>(nullptr, 16);
  upper->addWidget(makeKinds(offer));
  upper->addWidget(makeOrgans(offer.organs), 1);
  auto* form = new QFormLayout;
  form->addRow(tr("Instants"), phases_);
  form->addRow(tr("Whose they are"), makeIdentity());
  form->addRow(tr("Destination"), makeDestination(offer));
  auto* column = makeLayout<QVBoxLayout>(this, 12, {16, 16, 16, 16});
  column->addWidget(makeRemark(tr("For research and teaching, not for diagnosis."), this));
  column->addLayout(upper, 1);
  column->addLayout(form);
  column->addWidget(said_);
  column->addWidget(buttons);
  if (offer.hasScan)
    identity_->setPlaceholderText(tr("The files of the scan are being read"));
  else
    showNoIdentity();
  sync();
}

QWidget* DicomDialog::makeKinds(const Offer& offer) {
  auto* box = new QWidget;
  auto* column = makeLayout<QVBoxLayout>(box);
  column->addWidget(new QLabel(tr("Objects")));
  for (QCheckBox* kind : {segmentation_, measurements_, surfaces_, contours_}) {
    column->addWidget(kind);
    connect(kind, &QCheckBox::toggled, this, &DicomDialog::sync);
  }
  column->addStretch();
  if (!offer.hasScan) {
    contours_->setEnabled(false);
    contours_->setToolTip(tr("Contours need the slices of a scan"));
  }
  return box;
}

QWidget* DicomDialog::makeOrgans(const document::OrganList& organs) {
  auto* box = new QWidget;
  auto* column = makeLayout<QVBoxLayout>(box);
  auto* title = new QLabel(tr("Organs"));
  title->setBuddy(organs_);
  organs_->setObjectName(QStringLiteral("dicomOrgans"));
  organs_->setAccessibleName(tr("Organs"));
  organs_->setToolTip(tr("The organs that are written"));
  organs_->setTextElideMode(Qt::ElideMiddle);
  organs_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  organs_->setMinimumHeight(kOrgansHeight);
  for (const auto& organ : organs) {
    const QString name = inWords(presentation::labelOf(*organ));
    auto* item = new QListWidgetItem(name, organs_);
    item->setData(Qt::UserRole, text(organ->name)); // As the document has it.
    item->setToolTip(organ->closed() ? name : tr("%1 is open and has no inside").arg(name));
    item->setFlags(organ->closed() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable
                                   : Qt::NoItemFlags);
    item->setCheckState(organ->closed() ? Qt::Checked : Qt::Unchecked);
  }
  connect(organs_, &QListWidget::itemChanged, this, &DicomDialog::sync);
  column->addWidget(title);
  column->addWidget(organs_, 1);
  return box;
}

QWidget* DicomDialog::makeIdentity() {
  auto* box = new QWidget;
  auto* column = makeLayout<QVBoxLayout>(box);
  identity_->setObjectName(QStringLiteral("dicomIdentity"));
  identity_->setAccessibleName(tr("Whose they are"));
  identity_->setToolTip(tr("The elements of each file that say whose it is"));
  identity_->setReadOnly(true);
  identity_->setTabChangesFocus(true);
  identity_->setLineWrapMode(QPlainTextEdit::NoWrap);
  identity_->setFixedHeight(kIdentityHeight);
  connect(withoutIdentity_, &QCheckBox::toggled, this, &DicomDialog::sync);
  column->addWidget(identity_);
  column->addWidget(withoutIdentity_);
  return box;
}

QWidget* DicomDialog::makeDestination(const Offer& offer) {
  auto* box = new QWidget;
  auto* row = makeLayout<QHBoxLayout>(box);
  destination_->setObjectName(QStringLiteral("dicomDestination"));
  destination_->setAccessibleName(tr("Destination"));
  destination_->setToolTip(tr("A folder, or an archive that From the archive knows"));
  destination_->addItem(tr("Folder"));
  for (const clinic::ArchiveConnection& archive : archives_)
    destination_->addItem(text(archive.name));
  destination_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  destination_->setMinimumContentsLength(12);
  folder_->setObjectName(QStringLiteral("dicomFolder"));
  folder_->setAccessibleName(tr("Folder"));
  folder_->setToolTip(tr("Made when it is not there; no file in it is replaced"));
  folder_->setText(QDir::toNativeSeparators(offer.folder));
  choose_ = new QPushButton(tr("Choose..."));
  choose_->setToolTip(tr("Choose the folder"));
  choose_->setAutoDefault(false);
  connect(choose_, &QPushButton::clicked, this, &DicomDialog::chooseFolder);
  connect(folder_, &QLineEdit::textChanged, this, &DicomDialog::sync);
  connect(destination_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &DicomDialog::sync);
  row->addWidget(destination_);
  row->addWidget(folder_, 1);
  row->addWidget(choose_);
  return box;
}

void DicomDialog::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Export as DICOM"), folder_->text());
  if (!folder.isEmpty())
    folder_->setText(QDir::toNativeSeparators(folder));
}

void DicomDialog::showIdentity(const std::vector<clinic::IdentifyingElement>& elements) {
  QStringList lines;
  for (const clinic::IdentifyingElement& element : elements)
    lines << QLatin1String(element.keyword) + QStringLiteral(": ") + text(element.value);
  identity_->setPlainText(lines.join(QLatin1Char('\n')));
}

void DicomDialog::showNoIdentity() {
  identity_->setPlaceholderText(tr("No DICOM scan says whose they are: they get a study of their own."));
}

bool DicomDialog::toArchive() const {
  return destination_->currentIndex() > 0;
}

QString DicomDialog::whyNot() const {
  const Choice chosen = choice();
  const workbench::DicomKinds& kinds = chosen.kinds;
  if (!kinds.segmentation && !kinds.measurements && !kinds.surfaces && !kinds.contours)
    return tr("Choose at least one object.");
  if (chosen.organs.empty())
    return tr("Choose at least one organ; its surface has to be closed.");
  if (!toArchive() && chosen.folder.isEmpty())
    return tr("Choose a folder.");
  return {};
}

void DicomDialog::sync() {
  const bool archive = toArchive();
  folder_->setEnabled(!archive);
  choose_->setEnabled(!archive);
  identity_->setEnabled(!withoutIdentity_->isChecked());
  export_->setText(archive ? tr("Send") : tr("Export"));
  const QString reason = whyNot();
  export_->setEnabled(reason.isEmpty());
  said_->setText(reason);
}

DicomDialog::Choice DicomDialog::choice() const {
  Choice chosen;
  chosen.kinds.segmentation = segmentation_->isChecked();
  chosen.kinds.measurements = measurements_->isChecked();
  chosen.kinds.surfaces = surfaces_->isChecked();
  chosen.kinds.contours = contours_->isEnabled() && contours_->isChecked();
  for (int row = 0; row < organs_->count(); ++row)
    if (organs_->item(row)->checkState() == Qt::Checked)
      chosen.organs.push_back(organs_->item(row)->data(Qt::UserRole).toString().toStdString());
  chosen.phases = phases_->value();
  chosen.withoutIdentity = withoutIdentity_->isChecked();
  if (toArchive())
    chosen.archive = archives_[static_cast<std::size_t>(destination_->currentIndex() - 1)];
  else
    chosen.folder = QDir::fromNativeSeparators(folder_->text().trimmed());
  return chosen;
}

} // namespace viscera::app
