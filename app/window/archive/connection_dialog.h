#pragma once

#include <QDialog>
#include <QStringList>

#include "viscera/clinic/archive.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace viscera::app {

/// A dialog that asks where an archive is and how it is spoken to. What cannot work is said below the fields,
/// and is not accepted.
class ConnectionDialog final : public QDialog {
  Q_OBJECT

public:
  /// `taken` are the names of the other archives.
  ConnectionDialog(const clinic::ArchiveConnection& connection, QStringList taken, QWidget* parent);

  clinic::ArchiveConnection connection() const;

private:
  QWidget* makeCertificates();
  void chooseCertificates();
  /// Why it cannot be accepted; empty: it can.
  QString whyNot() const;
  QString remark() const;
  void sync();
  bool isWeb() const;

  QStringList taken_;
  QLineEdit* name_;
  QComboBox* kind_;
  QLineEdit* address_;
  QLineEdit* user_;
  QSpinBox* port_;
  QLineEdit* called_;
  QLineEdit* own_;
  QCheckBox* tls_;
  QLineEdit* certificates_;
  QSpinBox* patience_;
  QLabel* remark_;
  QPushButton* accept_ = nullptr;
};

} // namespace viscera::app
