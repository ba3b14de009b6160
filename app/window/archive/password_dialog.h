#pragma once

#include <QDialog>

#include <optional>

#include "window/archive/archive_client.h"

class QCheckBox;
class QLineEdit;

namespace viscera::app {

/// A dialog that asks for the password of an archive.
class PasswordDialog final : public QDialog {
  Q_OBJECT

public:
  /// `refused`: the one before was wrong; `canKeep`: there is a key ring.
  PasswordDialog(const clinic::ArchiveConnection& connection, bool refused, bool canKeep, QWidget* parent);

  ArchiveClient::Answer answer() const;
  /// Shows it and waits for the user; none when it was cancelled.
  static std::optional<ArchiveClient::Answer> ask(const clinic::ArchiveConnection& connection, bool refused,
                                                  bool canKeep, QWidget* parent);

private:
  QLineEdit* password_;
  QCheckBox* keep_;
};

} // namespace viscera::app
