#pragma once

#include <QWidget>

#include <vector>

#include "viscera/document/import_draft.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace viscera::app {

class OrganCheck;

/// A panel that shows the organs of files before they are imported: findings that several organs share, a
/// list of organs with what was found in each, buttons that repair, and Import and Cancel. Many organs can be
/// filtered by name and by finding, and included or left out together. The panel only sends signals; it does
/// not change the draft itself.
class ImportPanel final : public QWidget {
  Q_OBJECT

public:
  explicit ImportPanel(QWidget* parent = nullptr);

  /// Shows a draft under a title such as a file's name.
  void showDraft(const document::ImportDraft& draft, const QString& title);
  /// While a worker repairs, only Cancel is enabled.
  void setBusy(bool busy);

Q_SIGNALS:
  void accepted();
  void cancelled();
  void repairRequested(const std::vector<std::size_t>& organs, const std::string& repair);
  /// The same as `OrganCheck::previewRequested`.
  void previewRequested(std::size_t organ, const std::string& repair);
  void revertRequested(std::size_t organ);
  void includedChanged(const std::vector<std::size_t>& organs, bool included);

private:
  struct Card {
    std::size_t organ;
    QString name;
    bool questionable;
    OrganCheck* check;
  };

  QWidget* makeFilter();
  void addCommon(const document::ImportDraft& draft);
  void addOrgan(const document::ImportDraft& draft, std::size_t place);
  void fillFindings();
  void filter();
  void includeShown(bool included);

  QLabel* title_;
  QLabel* summary_;
  QLineEdit* name_;
  QComboBox* finding_;
  QWidget* filter_; ///< Shown, with the next two widgets, when there are many organs.
  QWidget* organs_;
  QVBoxLayout* column_;
  QPushButton* import_;
  std::vector<Card> cards_;
  std::vector<document::SharedFinding> shared_;
};

} // namespace viscera::app
