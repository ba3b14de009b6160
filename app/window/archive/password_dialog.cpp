#include "window/archive/password_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "window/widgets/ready_made.h"
#include "window/work/workspace.h"

namespace viscera::app {

PasswordDialog::PasswordDialog(const clinic::ArchiveConnection& connection, bool refused, bool canKeep,
                               QWidget* parent)
    : QDialog(parent), password_(new QLineEdit),
      keep_(new QCheckBox(tr("Keep it in the system's key ring"))) {
  setObjectName(QStringLiteral("archivePassword"));
  setWindowTitle(tr("Password"));
  const QString question = tr("Password of %1 at %2").arg(text(connection.user), text(connection.name));
  password_->setEchoMode(QLineEdit::Password);
  password_->setAccessibleName(question);
  keep_->setToolTip(canKeep ? tr("Else Viscera asks again after the next start")
                            : tr("There is no key ring; Viscera asks again after the next start"));
  keep_->setEnabled(canKeep);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = makeLayout<QVBoxLayout>(this, 12, {16, 16, 16, 16});
  if (refused)
    column->addWidget(makeRemark(tr("The archive refuses the user name or the password."), this));
  column->addWidget(makeRemark(question, this));
  column->addWidget(password_);
  column->addWidget(keep_);
  column->addWidget(buttons);
}

ArchiveClient::Answer PasswordDialog::answer() const {
  return {password_->text().toStdString(), keep_->isChecked()};
}

std::optional<ArchiveClient::Answer> PasswordDialog::ask(const clinic::ArchiveConnection& connection,
                                                         bool refused, bool canKeep, QWidget* parent) {
  PasswordDialog dialog(connection, refused, canKeep, parent);
  return dialog.exec() == Accepted ? std::optional(dialog.answer()) : std::nullopt;
}

} // namespace viscera::app
