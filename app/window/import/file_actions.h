#pragma once

#include <QObject>
#include <QStringList>

#include <functional>
#include <optional>

#include "viscera/core/phrase.h"
#include "viscera/document/import_draft.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"
#include "viscera/document/system_commands.h"
#include "window/work/actions.h"
#include "window/work/handle_placer.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

class QWidget;

namespace viscera::app {

class ArrivingSurfaces;

/// The actions that open and save files. A worker reads and writes, so the window stays usable; a failure
/// leaves the document unchanged and shows one message.
class FileActions final : public QObject {
  Q_OBJECT

public:
  FileActions(Workspace& workspace, HandlePlacer& placer, Settings& settings, QWidget* window);

  /// Adds "file.open", "file.openFolder", "file.check", "file.export", "handles.save" and "cage.load".
  void addTo(Actions& actions);

  /// Called with files whose contents the user should check before they are accepted by `take`. Without a
  /// checker, files are accepted as they are.
  using Checker = std::function<void(document::ImportDraft, const QStringList&)>;
  void setChecker(Checker checker) { checker_ = std::move(checker); }

  /// Sets the object that shows organs while other files are still being read. Without one, organs are shown
  /// when all files have been read.
  void setArrivingSurfaces(ArrivingSurfaces* arriving) { arriving_ = arriving; }

  /// Sets the function that opens a session file, which replaces everything. Without one, sessions are
  /// refused.
  void setSessionOpener(std::function<void(const QString& file)> opener) { openSession_ = std::move(opener); }

  /// Asks for files and opens them; with `check` they go to the checker even if nothing is odd.
  void chooseAndOpen(bool check = false);
  /// Asks for a folder of masks, as TotalSegmentator writes it, and opens it as one patient.
  void chooseAndOpenFolder();
  /// Opens organs, label maps and handles as one undo step, and a scan as another. Sample organs make room
  /// for the first files; later ones come beside those there are. Organs that come without handles get some.
  /// A message lists the files that cannot be read; the others are opened.
  void open(const QStringList& files, bool check = false);
  /// Whether opened files replace the present organs: true when there are none, or sample organs only.
  bool replacesPresent() const;
  /// Adds the accepted parts of a draft to the document.
  void take(const document::ImportDraft& draft, const QStringList& files);
  /// Asks where to, and writes the handles at rest as `.mrk.json`.
  void chooseAndSaveHandles();
  void saveHandles(const QString& file);
  /// Asks for a closed surface around the organs, and takes it as the cage.
  void chooseAndLoadCage();
  /// Reads a cage on a worker; a message tells the user whether the handles have become its corners or its
  /// vertices the handles.
  void loadCage(const QString& file);
  /// Asks where to, and writes the current organ as it is posed now.
  void chooseAndExportOrgan();
  void exportOrgan(const QString& file);

  /// What is said of files that are not there or cannot be read and were to be opened together with this
  /// one, last; empty when all have opened.
  QString unopenedBeside(const std::filesystem::path& file) const;

Q_SIGNALS:
  void filesOpened();
  /// One of the files was a scan, or the folder a cine study; it is in the document.
  void scanOpened();
  /// There are several series of scans at a place, to choose from; none was opened.
  void scansFound(const QString& place);
  /// Nothing was found in the files that were checked.
  void foundNothingOdd(const QStringList& files);
  void recentFilesChanged();

private:
  /// The contents of the files that were read.
  struct Read {
    document::ImportDraft draft;
    std::shared_ptr<const document::ScanItem> scan; ///< Null: none of them was one.
    std::optional<document::StudyItem> study;       ///< The place is a cine study, and nothing else was read.
    bool several = false; ///< There are several series to choose from, and none was read.
  };

  /// Reads what can be read, for a worker; throws what one of the files throws where that is nothing.
  static Read readAll(const std::vector<std::filesystem::path>& files,
                      const document::ArrivingOrganListener& arrives, document::Sessions sessions,
                      const std::shared_ptr<const document::ScanItem>& scan, Progress& progress);
  QString folder() const;
  /// One line for each file that does not exist.
  static QStringList missingAmong(const QStringList& files);
  void reportOpenFailure(const Error& error, const QStringList& files, bool check);
  /// Shows the problems in one message, with an offer to look for missing files.
  void sayProblems(const QStringList& missing, const QStringList& failures, bool check);
  void applyReadFiles(Read read, const QStringList& files, bool check);
  /// Opens a scan or study; `alone`: nothing else is opened with it.
  void takeImages(const document::Command& open, const QStringList& files, bool alone);
  void rememberFolder(const QString& file);
  void take(document::OpenedFiles opened, const QStringList& files);
  /// Chooses the organ that was opened, the first of those from this place in the document. Of several whole
  /// organs none is chosen: the first by the alphabet is no choice of the user.
  void chooseOpened(std::size_t firstNew);
  /// Sentences about organs that lie exactly where an organ of the document lies.
  QStringList coveredBy(std::size_t firstNew) const;
  void reviewOrImport(document::ImportDraft draft, const QStringList& files, bool check);
  void sayWarnings(const std::vector<Text>& warnings, QStringList lines = {});
  void takeCage(const document::GivenCage& cage, const QString& file);
  void saySaved(const QString& what, const QString& file);

  Workspace& workspace_;
  HandlePlacer& placer_;
  Settings& settings_;
  QWidget* window_;
  Checker checker_;
  ArrivingSurfaces* arriving_ = nullptr;
  QStringList named_;    ///< The files that were to be opened last.
  QStringList failures_; ///< What is said of those of them that cannot be read.
  std::function<void(const QString&)> openSession_;
};

} // namespace viscera::app
