#include "window/archive/connection_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

#include "window/widgets/ready_made.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr int kConnectionWidth = 520;
constexpr int kLongestAeTitle = 16;

bool isAeTitle(const QString& title) {
  return !title.trimmed().isEmpty() && title.size() <= kLongestAeTitle &&
         std::all_of(title.begin(), title.end(), [](QChar sign) {
           return sign.unicode() >= ' ' && sign.unicode() < 127 && sign != QLatin1Char('\\');
         });
}

bool isOwnMachine(const QString& address) {
  return address.contains(QLatin1String("://127.0.0.1")) || address.contains(QLatin1String("://localhost")) ||
         address.contains(QLatin1String("://[::1]"));
}

QSpinBox* makeNumber(int low, int high, int value) {
  auto* box = new QSpinBox;
  box->setRange(low, high);
  box->setValue(value);
  return box;
}

} // namespace

ConnectionDialog::ConnectionDialog(const clinic::ArchiveConnection& connection, QStringList taken,
                                   QWidget* parent)
    : QDialog(parent), taken_(std::move(taken)), name_(new QLineEdit(text(connection.name))),
      kind_(new QComboBox), address_(new QLineEdit(text(connection.address))),
      user_(new QLineEdit(text(connection.user))), port_(makeNumber(1, 65535, connection.port)),
      called_(new QLineEdit(text(connection.calledTitle))), own_(new QLineEdit(text(connection.ownTitle))),
      tls_(new QCheckBox(tr("Secure connection (TLS)"))),
      certificates_(new QLineEdit(text(connection.certificates))),
      patience_(makeNumber(1, 600, connection.patienceSeconds)), remark_(makeRemark({}, this)) {
  setObjectName(QStringLiteral("archiveConnection"));
  setWindowTitle(connection.name.empty() ? tr("Add an archive") : tr("Edit an archive"));
  setMinimumWidth(kConnectionWidth);
  name_->setObjectName(QStringLiteral("connectionName"));
  address_->setObjectName(QStringLiteral("connectionAddress"));
  kind_->addItem(tr("DICOMweb"));
  kind_->addItem(tr("Classic DICOM services (DIMSE)"));
  kind_->setCurrentIndex(connection.kind == clinic::ArchiveKind::dimse ? 1 : 0);
  tls_->setChecked(connection.tls);
  name_->setToolTip(tr("The name under which you choose the archive"));
  user_->setToolTip(tr("Leave it empty where the archive asks for no password"));
  called_->setToolTip(tr("The title (AE title) of the archive, at most 16 characters"));
  own_->setToolTip(tr("The title by which the archive knows this program"));
  patience_->setSuffix(QStringLiteral(" s"));
  patience_->setToolTip(tr("How long the archive may be silent"));
  auto* form = new QFormLayout;
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Kind"), kind_);
  form->addRow(tr("Address"), address_);
  form->addRow(tr("User"), user_);
  form->addRow(tr("Port"), port_);
  form->addRow(tr("Title of the archive"), called_);
  form->addRow(tr("Title of this program"), own_);
  form->addRow(QString(), tls_);
  form->addRow(tr("Trusted certificates"), makeCertificates());
  form->addRow(tr("Patience"), patience_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = makeLayout<QVBoxLayout>(this, 12, {16, 16, 16, 16});
  column->addLayout(form);
  column->addWidget(remark_);
  column->addStretch();
  column->addWidget(buttons);
  for (QLineEdit* field : {name_, address_, user_, called_, own_, certificates_})
    connect(field, &QLineEdit::textChanged, this, &ConnectionDialog::sync);
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ConnectionDialog::sync);
  sync();
}

QWidget* ConnectionDialog::makeCertificates() {
  auto* box = new QWidget;
  auto* row = makeLayout<QHBoxLayout>(box);
  certificates_->setPlaceholderText(tr("Those of the system"));
  certificates_->setToolTip(tr("A file with the certificate of the archive's issuer (.pem)"));
  auto* choose = new QPushButton(tr("Choose..."));
  choose->setToolTip(tr("Choose the file with the certificates"));
  connect(choose, &QPushButton::clicked, this, &ConnectionDialog::chooseCertificates);
  row->addWidget(certificates_, 1);
  row->addWidget(choose);
  return box;
}

void ConnectionDialog::chooseCertificates() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Trusted certificates"), certificates_->text(),
                                                    tr("Certificates (*.pem *.crt);;All files (*)"));
  if (!file.isEmpty())
    certificates_->setText(file);
}

bool ConnectionDialog::isWeb() const {
  return kind_->currentIndex() == 0;
}

QString ConnectionDialog::whyNot() const {
  const QString address = address_->text().trimmed();
  if (name_->text().trimmed().isEmpty())
    return tr("Give the archive a name.");
  if (taken_.contains(name_->text().trimmed()))
    return tr("Another archive has this name.");
  if (address.isEmpty())
    return tr("Type the address of the archive.");
  if (isWeb() && !address.startsWith(QLatin1String("http://")) &&
      !address.startsWith(QLatin1String("https://")))
    return tr("The address of DICOMweb begins with http:// or https://.");
  if (address.contains(QLatin1Char('@')))
    return tr("The address holds no user and no password.");
  if (!isWeb() && !(isAeTitle(called_->text()) && isAeTitle(own_->text())))
    return tr("A title has 1 to 16 plain characters.");
  return {};
}

QString ConnectionDialog::remark() const {
  const QString address = address_->text().trimmed();
  const bool readable =
      isWeb() ? address.startsWith(QLatin1String("http://")) && !isOwnMachine(address) : !tls_->isChecked();
  return readable ? tr("Images travel readable for others in the network, and so does a password.")
                  : QString();
}

void ConnectionDialog::sync() {
  const bool web = isWeb();
  user_->setEnabled(web);
  for (QWidget* field : {static_cast<QWidget*>(port_), static_cast<QWidget*>(called_),
                         static_cast<QWidget*>(own_), static_cast<QWidget*>(tls_)})
    field->setEnabled(!web);
  address_->setPlaceholderText(web ? QStringLiteral("https://archive.example/dicom-web")
                                   : QStringLiteral("archive.example"));
  const QString reason = whyNot();
  accept_->setEnabled(reason.isEmpty());
  remark_->setText(reason.isEmpty() ? remark() : reason);
}

clinic::ArchiveConnection ConnectionDialog::connection() const {
  clinic::ArchiveConnection made;
  made.name = name_->text().trimmed().toStdString();
  made.kind = isWeb() ? clinic::ArchiveKind::dicomWeb : clinic::ArchiveKind::dimse;
  made.address = address_->text().trimmed().toStdString();
  made.port = port_->value();
  made.certificates = certificates_->text().trimmed().toStdString();
  made.patienceSeconds = patience_->value();
  if (isWeb()) {
    made.user = user_->text().trimmed().toStdString();
    return made;
  }
  made.calledTitle = called_->text().trimmed().toStdString();
  made.ownTitle = own_->text().trimmed().toStdString();
  made.tls = tls_->isChecked();
  return made;
}

} // namespace viscera::app
