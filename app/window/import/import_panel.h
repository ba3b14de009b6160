#pragma once

#include <QWidget>

#include "viscera/document/import_draft.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace viscera::app {

/// What files hold before any of it is in the document: a list of organs with what was found out about them,
/// buttons that repair, and Import and Cancel. Changes nothing itself.
class ImportPanel final : public QWidget {
  Q_OBJECT

public:
  explicit ImportPanel(QWidget* parent = nullptr);

  /// Shows a draft under a title such as a file's name.
  void showDraft(const document::ImportDraft& draft, const QString& title);
  /// While a worker repairs nothing but Cancel can be pressed.
  void setBusy(bool busy);

Q_SIGNALS:
  void accepted();
  void cancelled();
  void repairRequested(const std::vector<std::size_t>& organs, const std::string& repair);
  void revertRequested(std::size_t organ);
  void includedChanged(std::size_t organ, bool included);

private:
  void addArrangement(const document::ImportDraft& draft);
  void addOrgan(const document::DraftOrgan& organ, std::size_t place, bool severalFiles);

  QLabel* title_;
  QLabel* summary_;
  QWidget* organs_;
  QVBoxLayout* column_;
  QPushButton* import_;
};

} // namespace viscera::app
