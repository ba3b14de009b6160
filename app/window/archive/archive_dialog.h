#pragma once

#include <QDialog>

#include <string>
#include <vector>

#include "viscera/clinic/archive.h"

class QComboBox;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

class ArchiveClient;
class WrappedLabel;

/// The dialog *From the archive*: the archives with their connections, the search for studies, the list of
/// what was found, and the progress of what is being fetched.
class ArchiveDialog final : public QDialog {
  Q_OBJECT

public:
  /// What is chosen to be opened.
  struct Choice {
    clinic::ArchiveConnection connection;
    std::string studyUid;
    std::string seriesUid; ///< Empty: the whole study.
    int images = -1;       ///< -1: not known.
  };

  /// `client` has to live longer. `chosen` is the name of the archive that is chosen at first.
  ArchiveDialog(ArchiveClient& client, const QString& chosen, QWidget* parent);

  /// Shows a sentence below the list.
  void say(const QString& sentence);

Q_SIGNALS:
  void openWanted(const viscera::app::ArchiveDialog::Choice& choice);
  void archiveChosen(const QString& name);

private:
  template <class Work>
  auto whileOpen(Work work);
  QLayout* makeArchives();
  QLayout* makeQuery();
  void makeList();
  QLayout* makeProgress();
  void fillArchives(const QString& chosen);
  const clinic::ArchiveConnection* present() const;
  void edit(bool added);
  void remove();
  void test();
  void search();
  void showStudies(const std::vector<clinic::ArchiveStudy>& studies);
  void fetchSeries(QTreeWidgetItem* item);
  void showSeries(const std::string& studyUid, const std::vector<clinic::ArchiveStudy>& studies);
  void openChosen();
  void sync();
  void syncProgress();
  /// Writes the list, and chooses this one of it.
  bool write(const std::vector<clinic::ArchiveConnection>& connections, const QString& chosen);

  ArchiveClient& client_;
  std::vector<clinic::ArchiveConnection> connections_;
  QComboBox* archives_;
  QPushButton *edit_ = nullptr, *remove_ = nullptr, *test_ = nullptr, *search_ = nullptr, *open_ = nullptr;
  QLineEdit *patientName_, *patientId_, *from_, *to_;
  QComboBox* modality_;
  QTreeWidget* list_;
  WrappedLabel* said_;
  QProgressBar* progress_;
  QPushButton* cancel_ = nullptr;
};

} // namespace viscera::app
