#pragma once

#include <QDialog>
#include <QString>

#include <optional>
#include <string>
#include <vector>

#include "viscera/clinic/archive.h"
#include "viscera/document/document.h"
#include "viscera/workbench/dicom_export.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace viscera::app {

class WrappedLabel;

/// The dialog *Export as DICOM*: which objects of which organs are written, at how many instants of the
/// motion, with whose names, and where they go. What cannot work is said below, and is not accepted.
class DicomDialog final : public QDialog {
  Q_OBJECT

public:
  /// What there is to export.
  struct Offer {
    document::OrganList organs;
    bool moves = false;   ///< A motion moves the organs.
    bool hasScan = false; ///< Whose files may say whose the organs are.
    std::vector<clinic::ArchiveConnection> archives;
    QString folder; ///< At first.
  };
  /// What the user wants.
  struct Choice {
    workbench::DicomKinds kinds;
    std::vector<std::string> organs;
    int phases = 0; ///< 0: the pose that is shown.
    bool withoutIdentity = false;
    std::optional<clinic::ArchiveConnection> archive; ///< None: into the folder.
    QString folder;
  };

  DicomDialog(const Offer& offer, QWidget* parent);

  Choice choice() const;
  /// Lists the elements that say whose the organs are.
  void showIdentity(const std::vector<clinic::IdentifyingElement>& elements);
  /// Says why there are none.
  void showNoIdentity();

private:
  QWidget* makeKinds(const Offer& offer);
  QWidget* makeOrgans(const document::OrganList& organs);
  QWidget* makeIdentity();
  QWidget* makeDestination(const Offer& offer);
  void chooseFolder();
  bool toArchive() const;
  /// Why it cannot be accepted; empty: it can.
  QString whyNot() const;
  void sync();

  std::vector<clinic::ArchiveConnection> archives_;
  QCheckBox *segmentation_, *measurements_, *surfaces_, *contours_;
  QListWidget* organs_;
  QSpinBox* phases_;
  QCheckBox* withoutIdentity_;
  QPlainTextEdit* identity_;
  QComboBox* destination_;
  QLineEdit* folder_;
  QPushButton *choose_ = nullptr, *export_ = nullptr;
  WrappedLabel* said_;
};

} // namespace viscera::app
